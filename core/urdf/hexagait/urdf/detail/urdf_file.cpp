// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tinyxml2.h>

#include <algorithm>
#include <hexagait/text/parse_number.hpp>
#include <hexagait/text/quantity.hpp>
#include <hexagait/urdf/detail/rotations.hpp>
#include <hexagait/urdf/detail/urdf_file.hpp>
#include <hexagait/urdf/detail/xml_size.hpp>
#include <map>

namespace hexagait {
namespace {

using tinyxml2::XMLElement;

constexpr std::string_view kSpace = " \t\r\n";

/// The numbers of a text; nothing if something else is among them, or one is not finite.
std::optional<std::vector<double>> numbers(std::string_view text) {
  std::vector<double> all;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
    if (text.empty()) return all;
    std::string_view word = text.substr(0, text.find_first_of(kSpace));
    text.remove_prefix(word.size());
    if (word.starts_with('+')) word.remove_prefix(1);
    const std::optional<double> value = parse_number<double>(word);
    if (!value || !std::isfinite(*value)) return {};
    all.push_back(*value);
  }
}

/// Where in the file's links, or joints, those of a name are.
using Names = std::map<std::string, int, std::less<>>;

/// The reader of one element, which names it in messages.
class Reader {
 public:
  explicit Reader(Violations& violations) : violations_(violations) {}

  UrdfFile read(const XMLElement& robot);

 private:
  void read_link(const XMLElement& element);
  void read_joint(const XMLElement& element);
  void read_limit(const XMLElement& element, FileJoint& joint);
  FileInertial inertial(const XMLElement& element);
  std::optional<Matrix3> inertia(const XMLElement& element);
  std::vector<FileShape> shapes(const XMLElement& link, const char* kind);
  std::optional<FileShape> shape(const XMLElement& element);
  Pose origin(const XMLElement& parent);
  std::string name(const XMLElement& element, const char* kind);
  template <class Item>
  void take_name(const XMLElement& element, Names& names, const std::vector<Item>& items,
                 const std::string& name);
  int end(const XMLElement& element, const char* kind);
  void join();
  void find_root();

  /// n numbers of an attribute; nothing if it is not there, or wrong.
  std::optional<std::vector<double>> values(const XMLElement& element, const char* attribute,
                                            std::size_t n);
  std::optional<double> value(const XMLElement& element, const char* attribute) {
    const auto one = values(element, attribute, 1);
    return one ? std::optional((*one)[0]) : std::nullopt;
  }
  std::optional<Vector3> vector(const XMLElement& element, const char* attribute) {
    const auto xyz = values(element, attribute, 3);
    return xyz ? std::optional(Vector3((*xyz)[0], (*xyz)[1], (*xyz)[2])) : std::nullopt;
  }

  void refuse(const XMLElement& at, const std::string& problem) {
    violations_.add(at.GetLineNum(), element_, problem);
  }

  Violations& violations_;
  std::string element_;
  UrdfFile file_;
  Names link_index_, joint_index_;
};

std::string attribute_of(const XMLElement& element, const char* name) {
  const char* text = element.Attribute(name);
  return text != nullptr ? text : "";
}

std::optional<std::vector<double>> Reader::values(const XMLElement& element, const char* attribute,
                                                  std::size_t n) {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return {};
  std::optional<std::vector<double>> found = numbers(text);
  // Limits of 1e16 are meant to be none; all else must leave room for sums and squares.
  const auto too_large = [](double value) { return std::abs(value) > kLargestQuantity; };
  const bool is_limit = std::string_view(element.Name()) == "limit";
  if (found && !is_limit && std::ranges::any_of(*found, too_large)) found.reset();
  if (found && found->size() == n) return found;
  refuse(element, std::string(element.Name()) + " " + attribute + " is '" + text + "'; " +
                      (n == 1 ? "a number is needed" : std::to_string(n) + " numbers are needed") +
                      (is_limit ? "" : ", at most 1e9"));
  return {};
}

Pose Reader::origin(const XMLElement& parent) {
  Pose pose;
  const XMLElement* element = parent.FirstChildElement("origin");
  if (element == nullptr) return pose;
  if (const auto xyz = vector(*element, "xyz")) pose.p = *xyz;
  if (const auto rpy = vector(*element, "rpy")) pose.R = rotation_of(*rpy);
  return pose;
}

std::string Reader::name(const XMLElement& element, const char* kind) {
  std::string name = attribute_of(element, "name");
  element_ = std::string(kind) + " " + name;
  if (name.empty()) refuse(element, "has no name");
  return name;
}

/// Notes the name of the next of the items; it must be a new one.
template <class Item>
void Reader::take_name(const XMLElement& element, Names& names, const std::vector<Item>& items,
                       const std::string& name) {
  const auto [other, is_new] = names.try_emplace(name, static_cast<int>(items.size()));
  if (is_new) return;
  const int line = items[static_cast<std::size_t>(other->second)].line;
  refuse(element,
         "has the name of the " + std::string(element.Name()) + " in line " + std::to_string(line));
}

std::optional<Matrix3> Reader::inertia(const XMLElement& element) {
  constexpr const char* kNames[] = {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
  double entry[6];
  bool whole = true;
  for (int i = 0; i < 6; ++i) {
    const std::optional<double> number = value(element, kNames[i]);
    whole &= number.has_value();
    entry[i] = number.value_or(0.0);
  }
  if (!whole) return {};
  Matrix3 inertia;
  inertia << entry[0], entry[1], entry[2],  //
      entry[1], entry[3], entry[4],         //
      entry[2], entry[4], entry[5];
  return inertia;
}

FileInertial Reader::inertial(const XMLElement& element) {
  FileInertial inertial;
  inertial.line = element.GetLineNum();
  inertial.X_LM = origin(element);
  if (const XMLElement* mass = element.FirstChildElement("mass"))
    inertial.mass = value(*mass, "value");
  if (const XMLElement* tensor = element.FirstChildElement("inertia"))
    inertial.inertia_M = inertia(*tensor);
  if (inertial.mass.value_or(0.0) < 0.0)
    refuse(element, "mass is " + in_words(*inertial.mass) + " kg; it must be positive");
  return inertial;
}

std::optional<FileShape> Reader::shape(const XMLElement& element) {
  FileShape shape;
  shape.line = element.GetLineNum();
  shape.X_LS = origin(element);
  const XMLElement* geometry = element.FirstChildElement("geometry");
  const XMLElement* solid = geometry != nullptr ? geometry->FirstChildElement() : nullptr;
  if (solid == nullptr) return {};
  const std::string kind = solid->Name();
  int sizes = 0;
  if (kind == "box") {
    shape.size = vector(*solid, "size").value_or(Vector3::Zero());
    sizes = 3;
  } else if (kind == "cylinder" || kind == "capsule") {
    shape.kind = FileShape::Kind::cylinder;
    shape.size << value(*solid, "radius").value_or(0.0), value(*solid, "length").value_or(0.0), 0.0;
    sizes = 2;
  } else if (kind == "sphere") {
    shape.kind = FileShape::Kind::sphere;
    shape.size << value(*solid, "radius").value_or(0.0), 0.0, 0.0;
    sizes = 1;
  } else if (kind == "mesh") {
    shape.kind = FileShape::Kind::mesh;
    shape.mesh = attribute_of(*solid, "filename");
    shape.size = vector(*solid, "scale").value_or(Vector3::Ones());
  } else {
    refuse(*solid, "geometry is <" + kind + ">; box, cylinder, sphere or mesh is needed");
  }
  for (int i = 0; i < sizes; ++i)
    if (!(shape.size[i] > 0.0))
      refuse(*solid, std::string(element.Name()) + " size is " + in_words(shape.size[i]) +
                         " m; it must be positive");
  return shape;
}

std::vector<FileShape> Reader::shapes(const XMLElement& link, const char* kind) {
  std::vector<FileShape> all;
  for (const XMLElement* element = link.FirstChildElement(kind); element != nullptr;
       element = element->NextSiblingElement(kind))
    if (std::optional<FileShape> found = shape(*element)) all.push_back(*std::move(found));
  return all;
}

void Reader::read_link(const XMLElement& element) {
  FileLink link;
  link.name = name(element, "link");
  link.line = element.GetLineNum();
  take_name(element, link_index_, file_.links, link.name);
  if (const XMLElement* inertia = element.FirstChildElement("inertial"))
    link.inertial = inertial(*inertia);
  link.collisions = shapes(element, "collision");
  link.visuals = shapes(element, "visual");
  file_.links.push_back(std::move(link));
}

/// The link at an end of a joint.
int Reader::end(const XMLElement& element, const char* kind) {
  const XMLElement* child = element.FirstChildElement(kind);
  const std::string link = child != nullptr ? attribute_of(*child, "link") : "";
  const auto found = link_index_.find(link);
  if (found != link_index_.end()) return found->second;
  refuse(child != nullptr ? *child : element,
         std::string(kind) + " is '" + link + "'; there is no such link");
  return -1;
}

void Reader::read_limit(const XMLElement& element, FileJoint& joint) {
  joint.lower = value(element, "lower");
  joint.upper = value(element, "upper");
  joint.velocity = value(element, "velocity");
  joint.effort = value(element, "effort");
}

void Reader::read_joint(const XMLElement& element) {
  using Type = FileJoint::Type;
  static const std::map<std::string, Type, std::less<>> kTypes = {
      {"fixed", Type::fixed},           {"revolute", Type::revolute},
      {"continuous", Type::continuous}, {"prismatic", Type::prismatic},
      {"floating", Type::floating},     {"planar", Type::planar}};
  FileJoint joint;
  joint.name = name(element, "joint");
  joint.line = element.GetLineNum();
  take_name(element, joint_index_, file_.joints, joint.name);

  const std::string type = attribute_of(element, "type");
  if (const auto known = kTypes.find(type); known != kTypes.end())
    joint.type = known->second;
  else
    refuse(element, "type is '" + type +
                        "'; it must be fixed, revolute, continuous, prismatic, floating or planar");
  joint.parent = end(element, "parent");
  joint.child = end(element, "child");
  joint.X_PJ = origin(element);
  if (const XMLElement* axis = element.FirstChildElement("axis"))
    joint.axis = vector(*axis, "xyz").value_or(joint.axis);
  if (joint.turns() && joint.axis.isZero())
    refuse(element, "axis has length 0; it must be a direction");
  if (const XMLElement* limit = element.FirstChildElement("limit")) read_limit(*limit, joint);
  if (const XMLElement* mimic = element.FirstChildElement("mimic"))
    joint.mimics = attribute_of(*mimic, "joint");
  file_.joints.push_back(std::move(joint));
}

/// Tells the links of their joints.
void Reader::join() {
  for (std::size_t i = 0; i < file_.joints.size(); ++i) {
    const FileJoint& joint = file_.joints[i];
    if (joint.parent < 0 || joint.child < 0) continue;
    FileLink& child = file_.link(joint.child);
    if (child.parent_joint >= 0) {
      const std::string& first = file_.joint(child.parent_joint).name;
      violations_.add(
          joint.line, "link " + child.name,
          "has two parents, by the joints " + first + " and " + joint.name + "; a robot is a tree");
      continue;
    }
    child.parent_joint = static_cast<int>(i);
    file_.link(joint.parent).child_joints.push_back(static_cast<int>(i));
  }
}

/// One link without parent, from which all others hang.
void Reader::find_root() {
  for (std::size_t i = 0; i < file_.links.size(); ++i) {
    const FileLink& link = file_.links[i];
    if (link.parent_joint >= 0) continue;
    if (file_.root >= 0)
      violations_.add(
          link.line, "link " + link.name,
          "has no parent, nor has " + file_.link(file_.root).name + "; a robot has one root");
    else
      file_.root = static_cast<int>(i);
  }
  std::vector<int> reached = {file_.root};
  for (std::size_t i = 0; file_.root >= 0 && i < reached.size(); ++i)
    for (const int joint : file_.link(reached[i]).child_joints)
      reached.push_back(file_.joint(joint).child);
  const std::size_t missing = file_.links.size() - (file_.root >= 0 ? reached.size() : 0);
  if (violations_.empty() && missing > 0)
    violations_.add("robot " + file_.name,
                    std::to_string(missing) + " of " + std::to_string(file_.links.size()) +
                        " links do not hang from the root link; a robot is a tree");
}

UrdfFile Reader::read(const XMLElement& robot) {
  file_.name = attribute_of(robot, "name");
  for (const XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link"))
    read_link(*link);
  for (const XMLElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint"))
    read_joint(*joint);
  if (file_.links.empty())
    violations_.add(robot.GetLineNum(), "robot " + file_.name, "has no links");
  join();
  find_root();
  return std::move(file_);
}

/// Finds what only xacro understands: its line, or 0.
struct FindsXacro : tinyxml2::XMLVisitor {
  int line = 0;
  std::string what;
  bool VisitEnter(const XMLElement& element, const tinyxml2::XMLAttribute* attribute) override {
    if (line == 0 && std::string_view(element.Name()).starts_with("xacro:"))
      line = element.GetLineNum(), what = element.Name();
    for (; line == 0 && attribute != nullptr; attribute = attribute->Next()) {
      const std::string_view text = attribute->Value();
      if (text.find("${") != text.npos || text.find("$(") != text.npos)
        line = attribute->GetLineNum(), what = attribute->Value();
    }
    return line == 0;
  }
};

}  // namespace

std::optional<UrdfFile> read_urdf_file(const std::string& xml, Violations& violations) {
  if (const std::string problem = too_large(xml); !problem.empty()) {
    violations.add("URDF", problem);
    return {};
  }
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.c_str(), xml.size()) != tinyxml2::XML_SUCCESS) {
    violations.add(document.ErrorLineNum(), "URDF",
                   std::string("is no XML (") + document.ErrorName() +
                       "); it must be XML with a <robot> element and its links and joints");
    return {};
  }
  const XMLElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) {
    violations.add("URDF", "has no <robot> element; it must have one, with links and joints");
    return {};
  }
  FindsXacro xacro;
  robot->Accept(&xacro);
  if (xacro.line > 0) {
    violations.add(
        xacro.line, "URDF",
        "'" + xacro.what +
            "' is of xacro, not of URDF; make a URDF of it first: xacro robot.urdf.xacro "
            "> robot.urdf");
    return {};
  }
  const std::size_t before = violations.size();
  UrdfFile file = Reader(violations).read(*robot);
  if (violations.size() > before) return {};
  return file;
}

}  // namespace hexagait
