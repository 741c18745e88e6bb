// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <hexagait/text/invalid_input.hpp>
#include <hexagait/viewer/server/page_files.hpp>
#include <hexagait/viewer/server/server.hpp>
#include <hexagait/viewer/session/session.hpp>
#include <testing/argos_walk.hpp>

namespace hexagait::viewer {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A client by hand: what a browser would not send can be sent.
class Socket {
 public:
  explicit Socket(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval patience{5, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~Socket() { close(socket_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void send(std::string_view bytes) const {
    EXPECT_EQ(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }

  // Up to the empty line, or the end.
  std::string header() {
    while (buffer_.find("\r\n\r\n") == std::string::npos)
      if (!fill()) return std::exchange(buffer_, {});
    const std::size_t end = buffer_.find("\r\n\r\n") + 4;
    const std::string result = buffer_.substr(0, end);
    buffer_.erase(0, end);
    return result;
  }

  // A masked text message; the mask is 0.
  void send_text(const std::string& text, unsigned char first = 0x81) const {
    std::string bytes(1, static_cast<char>(first));
    if (text.size() < 126) {
      bytes += static_cast<char>(0x80U | text.size());
    } else {
      bytes += {static_cast<char>(0xFE), static_cast<char>(text.size() >> 8U),
                static_cast<char>(text.size() & 0xFFU)};
    }
    send(bytes + std::string(4, '\0') + text);
  }

  // The next message from the server, its opcode first; empty at the end.
  std::string message() {
    if (!need(2)) return {};
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(buffer_[k]); };
    std::size_t size = byte(1) & 0x7FU, head = 2;
    if (size == 126) {
      if (!need(4)) return {};
      size = 256U * byte(2) + byte(3);
      head = 4;
    } else if (size == 127) {
      if (!need(10)) return {};
      size = 0;
      for (std::size_t k = 2; k < 10; ++k) size = 256U * size + byte(k);
      head = 10;
    }
    if (!need(head + size)) return {};
    std::string result(1, static_cast<char>(byte(0) & 0x0FU));
    result += buffer_.substr(head, size);
    buffer_.erase(0, head + size);
    return result;
  }

  // The next text message that holds this.
  std::string text_with(std::string_view what) {
    for (int k = 0; k < 1000; ++k) {
      const std::string text = message();
      if (text.empty() || (text[0] == 1 && text.find(what) != std::string::npos)) return text;
    }
    return {};
  }

 private:
  bool fill() {
    char bytes[4096];
    const ssize_t size = recv(socket_, bytes, sizeof bytes, 0);
    if (size > 0) buffer_.append(bytes, static_cast<std::size_t>(size));
    return size > 0;
  }
  bool need(std::size_t size) {
    while (buffer_.size() < size)
      if (!fill()) return false;
    return true;
  }

  int socket_;
  std::string buffer_;
};

SessionOptions options() {
  SessionOptions result;
  result.robot = testing::argos();
  result.heading = heading_control::Heading::straight(0.0);
  return result;
}

class Served : public ::testing::Test {
 protected:
  explicit Served(Access access = {}) : session_(options()), server_(std::move(access), session_) {
    thread_ = std::thread([this] { server_.run(stop_); });
  }
  ~Served() override {
    stop_ = true;
    thread_.join();
  }

  [[nodiscard]] std::string host() const { return "127.0.0.1:" + std::to_string(server_.port()); }

  // The answer to a request to steer.
  std::string upgrade(Socket& socket, const std::string& host, const std::string& more = "",
                      const std::string& path = "/ws") const {
    socket.send("GET " + path + " HTTP/1.1\r\nHost: " + host +
                "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n" +
                more + "\r\n");
    return socket.header();
  }

  Session session_;
  Server server_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

class ServedWithToken : public Served {
 protected:
  ServedWithToken() : Served({.bind = "127.0.0.1", .port = 0, .token = "c0ffee"}) {}
};

constexpr const char* kWelcome = "HTTP/1.1 101";

TEST_F(Served, StreamsSceneGroundSetupAndFramesAfterAHello) {
  Socket socket(server_.port());
  ASSERT_THAT(upgrade(socket, host(), "Origin: http://" + host() + "\r\n"), StartsWith(kWelcome));
  EXPECT_THAT(socket.message(), HasSubstr("\"hello\""));
  EXPECT_THAT(socket.message(), HasSubstr("\"scene\""));
  EXPECT_THAT(socket.message(), HasSubstr("\"ground\""));
  EXPECT_THAT(socket.message(), HasSubstr("\"setup\""));
  std::uint32_t last = 0;
  for (int k = 0; k < 20; ++k) {
    const std::string frame = socket.message();
    ASSERT_EQ(frame[0], 2);
    const PoseFrame f = decode(std::string_view(frame).substr(1));
    EXPECT_GT(f.tick, last);
    last = f.tick;
  }
}

TEST_F(Served, IsSteeredByMessages) {
  Socket socket(server_.port());
  upgrade(socket, host());
  socket.send_text(R"({"type":"drive","radius":2})");
  for (int k = 0; k < 100; ++k) {
    const std::string message = socket.message();
    if (message[0] == 2 && decode(std::string_view(message).substr(1)).k > 0.1) return;
  }
  FAIL() << "it does not turn";
}

TEST_F(Served, RefusesForeignPagesAndForeignNames) {
  const std::string origins[] = {"http://evil.example",
                                 "http://evil.example:" + std::to_string(server_.port()), "null",
                                 "https://" + host()};
  for (const std::string& origin : origins) {
    Socket socket(server_.port());
    EXPECT_THAT(upgrade(socket, host(), "Origin: " + origin + "\r\n"), Not(StartsWith(kWelcome)))
        << origin;
  }
  Socket rebound(server_.port());
  EXPECT_THAT(upgrade(rebound, "evil.example:" + std::to_string(server_.port())),
              Not(StartsWith(kWelcome)));
  Socket elsewhere(server_.port());
  EXPECT_THAT(upgrade(elsewhere, host(), "", "/other"), Not(StartsWith(kWelcome)));
}

TEST_F(ServedWithToken, AsksForItsToken) {
  EXPECT_THAT(server_.url(), HasSubstr("#token=c0ffee"));
  for (const char* const path : {"/ws", "/ws?token=", "/ws?token=c0ffe", "/ws?nekot=c0ffee"}) {
    Socket socket(server_.port());
    EXPECT_THAT(upgrade(socket, host(), "", path), Not(StartsWith(kWelcome))) << path;
  }
  Socket socket(server_.port());
  EXPECT_THAT(upgrade(socket, host(), "", "/ws?token=c0ffee"), StartsWith(kWelcome));
}

TEST_F(Served, AnswersNonsenseByAnErrorAndGoesOn) {
  Socket socket(server_.port());
  upgrade(socket, host());
  socket.send_text("nonsense");
  EXPECT_THAT(socket.text_with("error"), HasSubstr("not JSON"));
  socket.send_text("\xFF\xFE");
  EXPECT_THAT(socket.text_with("error"), HasSubstr("not UTF-8"));
  socket.send_text(std::string(20000, ' '));
  EXPECT_THAT(socket.text_with("error"), HasSubstr("more than 4096 bytes"));
  const std::string action = R"({"type":"action","name":"a","yaml":")";
  socket.send_text(action + std::string(60000, 'x') + "\"}");  // of allowed length, and no action
  EXPECT_THAT(socket.text_with("refused"), HasSubstr(R"("name":"a")"));
  socket.send_text(action, 0x01);
  for (int k = 0; k < 4; ++k) socket.send_text(std::string(50000, 'x'), 0x00);
  socket.send_text("\"}", 0x80);
  EXPECT_THAT(socket.text_with("error"), HasSubstr("more than 135168 bytes"));
  socket.send_text(R"({"type":"st)", 0x01);  // in two fragments
  socket.send_text(R"(op"})", 0x80);
  for (int k = 0; k < 200; ++k) {
    const std::string message = socket.message();
    if (message[0] == 2 && !decode(std::string_view(message).substr(1)).moving) return;
  }
  FAIL() << "it does not stop";
}

// A client that never reads: its socket fills up, and the walk goes on in real time for the others.
TEST_F(Served, IsNotDelayedByAClientThatReadsNothing) {
  Socket idle(server_.port()), watcher(server_.port());
  upgrade(idle, host());
  upgrade(watcher, host());
  const std::uint64_t before = session_.statistics().ticks;
  const auto begin = Clock::now();
  for (int k = 0; k < 60; ++k) ASSERT_FALSE(watcher.message().empty());
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  EXPECT_GT(static_cast<double>(session_.statistics().ticks - before), 0.5 * seconds / 0.002);
}

TEST_F(Served, TakesEightClientsAndNoMore) {
  std::vector<std::unique_ptr<Socket>> sockets;
  for (int k = 0; k < Server::kMostClients; ++k) {
    sockets.push_back(std::make_unique<Socket>(server_.port()));
    ASSERT_THAT(upgrade(*sockets.back(), host()), StartsWith(kWelcome));
  }
  Socket ninth(server_.port());
  EXPECT_THAT(upgrade(ninth, host()), Not(StartsWith(kWelcome)));
}

TEST_F(Served, HasThePageWithAPolicyAndNothingElse) {
  const auto get = [&](const std::string& path, const std::string& host) {
    Socket socket(server_.port());
    socket.send("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n\r\n");
    return socket.header();
  };
  for (const char* const path : {"/etc/passwd", "/../../etc/passwd", "/index.html/x", "/%2e%2e/x"})
    EXPECT_THAT(get(path, host()), Not(HasSubstr("200 OK"))) << path;
  if (page_files().empty()) GTEST_SKIP() << kNoPage;
  const std::string page = get("/", host());
  EXPECT_THAT(page, HasSubstr("200 OK"));
  EXPECT_THAT(page, HasSubstr("script-src 'self'"));
  EXPECT_THAT(page, Not(HasSubstr("unsafe")));
  EXPECT_THAT(get("/", "evil.example"), HasSubstr("403"));
}

TEST_F(Served, SaysWhichOptionHelpsWhereThePortIsTaken) {
  try {
    const Server second({.bind = "127.0.0.1", .port = server_.port(), .token = {}}, session_);
    FAIL() << "two servers on one port";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("--port"));
  }
}

TEST(Server, RefusesAnAddressThatThisMachineHasNot) {
  Session session(options());
  EXPECT_THROW(Server({.bind = "192.0.2.7", .port = 0, .token = {}}, session), InvalidInput);
}

}  // namespace
}  // namespace hexagait::viewer
