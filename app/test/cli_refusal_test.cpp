// SPDX-FileCopyrightText: 2026 The hexagait authors
// SPDX-License-Identifier: BSD-3-Clause
#include <testing/source_path.hpp>

#include "cli_fixture.hpp"

// Bad usage and bad input: one message that says what, where, and what would be right.
namespace hexagait::app {
namespace {

TEST_F(Cli, RefusesRobotsThatAreNone) {
  refuses("walk --robot nobody", {"--robot", "'nobody'", "argos", "genghis2d"});
  refuses("walk --robot agros", {"'agros'", "did you mean 'argos'?"});
  refuses("walk --robot missing.urdf", {"--robot", "missing.urdf", "URDF"});
  refuses("walk --robot /", {"--robot", "'/'"});
  refuses("robot missing.urdf", {"missing.urdf"});
  write("text.urdf", "this is not XML");
  refuses("walk --robot ../text.urdf", {"text.urdf", "URDF"});
}

TEST_F(Cli, RefusesUnknownTerrainsAndNamesTheKnown) {
  refuses("walk --terrain swamp", {"terrain", "swamp", "flat", "boxes:H,WIDTH", "steps:H,WIDTH"});
  refuses("walk --terrain bxes:0.1", {"did you mean 'boxes'?"});
  refuses("walk --robot genghis2d --terrain stpe:0.1", {"did you mean 'step'?"});
  refuses("walk --terrain boxes:10deg", {"'10deg' is not a length", "10cm"});
  refuses("walk --terrain boxes:1e300", {"out of range"});
  refuses("walk --terrain boxes:-1", {"boxes:-1", "the height must be 0 or more"});
  refuses("walk --terrain boxes:nan", {"boxes:nan"});
}

TEST_F(Cli, RefusesNumbersOutOfRange) {
  for (const char* value : {"0", "-1", "nan", "inf", "soon", "1e9", "5m", "5deg"})
    refuses(std::string("walk --seconds ") + value, {"--seconds", "seconds"});
  for (const char* value : {"one", "-1", "1.5", "99999999999999999999"})
    refuses(std::string("walk --seed ") + value, {"--seed", "whole number"});
  for (const char* value : {"0", "-2", "nan", "far"})
    refuses(std::string("walk --distance ") + value, {"--distance", value, "metres"});
  refuses("walk --random-posture 3", {"--random-posture", "'3'", "workspaces"});
  refuses("walk --set step.hight=4cm", {"--set", "step.hight", "step.height"});
  refuses("walk --set step.height=-4cm", {"--set", "step.height", "greater than 0"});
  refuses("walk --set step.height", {"--set", "NAME=VALUE"});
  refuses("walk --params none.yaml", {"none.yaml"});
  refuses("walk --speed fast", {"--speed", "'fast'"});
  refuses("walk --random-commands 0", {"--random-commands", "'0'"});
}

TEST_F(Cli, RefusesPlantsThatAreNoneAndTellsAllAtOnce) {
  refuses("walk --plant rael", {"--plant", "'rael'", "did you mean 'real'?"});
  refuses("walk --joint-noise -1mrad --late-ticks 200% --sensing-delay 2s",
          {"--joint-noise is '-1mrad'; it must be an angle from 0 to 0.2 rad",
           "--late-ticks is '200%'; it must be a share from 0 to 1",
           "--sensing-delay is '2s'; it must be a time from 0 to 1 s"});
  refuses("walk --fault dead:LX", {"'dead:LX'", "no leg 'LX'", "LF, RF, LM, RM, LR, RR"});
  refuses("walk --fault ded:LF --fault weak:LF_knee:2",
          {"--fault", "did you mean 'dead'?", "'2' must be a share from 0 to 1"});
  refuses("run nod --fault dead:7", {"no leg '7'"});
  refuses("walk --plant real+frction:1", {"--plant", "did you mean 'friction'?"});
  refuses("walk --servo hobby", {"--servo", "'hobby'", "position_only"});
  refuses("run nod --velocity-limits none", {"--velocity-limits", "'none'", "off or on"});
  refuses("run nod --mass-error 2", {"--mass-error is '2'", "0.9"});
  refuses("run nod --servo position-only --controller virtual_model", {"--servo", "--controller"});
  for (const char* name : {"table1", "fg16_fig6", "sensitivity", "all"})
    refuses(
        std::string("experiment ") + name + " --plant real",
        {"the plant is 'real'", "take a plant", "fig9, fig10, fig11, wave_family, walks, rates"});
  refuses("experiment walks --joint-noise -1mrad", {"--joint-noise is '-1mrad'"});
  refuses("walk --robot genghis2d --friction 0.4", {"--plant", "genghis2d"});
}

TEST_F(Cli, RefusesHeadingsThatAreNone) {
  refuses("walk --radius 0", {"--radius", "spin"});
  refuses("walk --radius nan", {"--radius", "'nan'", "inf"});
  refuses("walk --crab nan", {"--crab", "'nan'", "30deg"});
  refuses("walk --crab inf", {"--crab", "'inf'"});
  refuses("walk --crab 45", {"--crab", "'45'", "radians and at most 2π; write 45deg"});
  refuses("walk --crab 1e300", {"--crab", "'1e300'"});
  refuses("walk --radius 1e300", {"--radius", "'1e300'", "out of range"});
  refuses("walk --spin left", {"--spin", "'left'", "ccw", "cw"});
  write("bad.yaml", "- {at: 0}\n- {at: 1, spin: left}\n");
  refuses("walk --commands ../bad.yaml", {"../bad.yaml:2", "\"left\""});
  refuses("walk --commands none.yaml", {"none.yaml", "No such file"});
  refuses("walk --commands ..", {"..: is a directory"});
  write("twice.yaml", "- {at: 0, radius: 1, radius: 2}\n");
  refuses("walk --commands ../twice.yaml", {"twice.yaml:1:22", "\"radius\" stands here a second"});
}

TEST_F(Cli, RefusesGaitsThatItDoesNotKnow) {
  for (const char* value : {"trot", "wave", "wave:0.4", "wave:1", "Free"})
    refuses(std::string("walk --gait ") + value, {"--gait", "free", "tripod", "wave:BETA"});
  for (const char* value : {"0.49", "1", "nan", "half", "0.7x"})
    refuses(std::string("walk --duty-factor ") + value, {"--duty-factor", "0.5", "less than 1"});
  refuses("walk --gait tripd", {"did you mean 'tripod'?"});
  refuses("walk --gait tripod --duty-factor 0.75", {"--gait", "--duty-factor"});
  write("beta.yaml", "- {at: 0}\n- {at: 1, duty_factor: 0.3}\n");
  refuses("walk --commands ../beta.yaml", {"../beta.yaml:2", "duty_factor", "\"0.3\"", "0.5"});
}

TEST_F(Cli, RefusesOptionsThatContradict) {
  refuses("walk --radius 1 --spin cw", {"--radius", "--spin"});
  refuses("walk --crab 1 --spin cw", {"--crab", "--spin"});
  refuses("walk --commands x.yaml --random-commands 3", {"--commands", "--random-commands"});
  refuses("walk --commands x.yaml --radius 3", {"--commands", "--radius"});
  refuses("walk --physics-step 0.003 --control-period 0.004",
          {"--control-period", "0.004", "0.003", "whole number"});
  refuses("walk --physics-step 0", {"--physics-step", "'0'"});
  for (const char* period : {"0", "nan", "0.5", "-0.002", "0.9ms", "21ms", "2m"})
    refuses(std::string("walk --control-period ") + period,
            {"--control-period", period, "1ms to 20ms"});
  refuses("walk --physics-step 0.002 --control-period 0.003",
          {"--control-period", "0.003", "0.002 s", "whole number"});
}

TEST_F(Cli, RefusesWhatItDoesNotKnow) {
  refuses("", {"--help"});
  refuses("run", {"action", "--help"});
  refuses("chek push_up", {"--help"});
  refuses("walk --fast", {"--fast", "--help"});
  refuses("walk --seconds", {"--seconds"});
  refuses("experiment fig99", {"fig99", "fig9", "fig10", "all"});
  refuses("experiment fig4 --title big", {"--title", "big", "none"});
  refuses("experiment fg16fig7", {"did you mean 'fg16_fig7'?"});
}

TEST_F(Cli, NamesTheCommandOrOptionThatWasProbablyMeant) {
  refuses("wlak", {"'wlak'", "did you mean 'walk'?"});
  refuses("walk --terrain heightmap:5cm,2m,no.png", {"no.png"});
  refuses("walk --terrain heightmap:5cm", {"its length or its file is missing"});
  refuses("walk --robot genghis2d --gait clocked", {"clocked", "three dimensions"});
  refuses("terrains boxes:5cm", {"--plot"});
  refuses("terrains hills --plot a.png", {"unknown kind"});
  refuses("terrains --plot a.jpg", {"--plot", "a.jpg"});
  refuses("experiment rough --seeds 0", {"--seeds is '0'"});
  refuses("experiment fig9 --seeds 3", {"--seeds is an option of rough"});
  refuses("experiment fig9 --shard 1/2", {"--shard is an option of rough"});
  refuses("experiment rough --shard 3/2", {"from 1 to 2"});
  refuses("list robotz", {"'robotz'", "did you mean 'robots'?", "terrains"});
  refuses("walk --terain flat", {"'--terain'", "did you mean '--terrain'?", "walk --help"});
  refuses("run nod --contoller=kinematic", {"'--contoller'", "did you mean '--controller'?"});
  refuses("--vresion", {"'--vresion'", "did you mean '--version'?"});
}

TEST_F(Cli, RefusesAnEmptyValue) {
  for (const std::string option : {"--commands", "--seconds", "--seed", "--radius", "--trace"})
    refuses("walk " + option + " ''", {option, "is empty"});
  refuses("robot ''", {"is empty"});
}

TEST_F(Cli, FindsAFileInTheFolderAndSaysHowToNameOneThatLacksItsSuffix) {
  fs::copy_file(fs::path(testing::source_path("robots/argos.urdf")), here() / "desk_noext");
  EXPECT_THAT(run("robot desk_noext").out, HasSubstr("6 legs"));
  fs::rename(here() / "desk_noext", here() / ".." / "desk.urdf");
  refuses("robot ../desk", {"'../desk'", "did you mean '../desk.urdf'?"});
}

TEST_F(Cli, RefusesFilesThatItCouldNotWriteBeforeItWalks) {
  refuses("walk --seconds 86400 --plot walk.bmp", {"--plot", "walk.bmp", ".png"});
  refuses("walk --seconds 86400 --trace walk.txt", {"--trace", "walk.txt", ".csv"});
  refuses("walk --seconds 86400 --trace none/walk.csv", {"--trace", "none", "No such file"});
  refuses("walk --seconds 86400 --trace /proc/walk.csv", {"--trace", "/proc"});
  fs::create_directory(here() / ".." / "walk.csv");
  refuses("walk --seconds 86400 --trace ../walk.csv", {"--trace", "not a file"});
}

TEST_F(Cli, SaysHowToGetGnuplotWhenThereIsNone) {
  prefix_ = "PATH=/nowhere; export PATH; ";
  refuses("walk --seconds 86400 --plot walk.png", {"gnuplot", "apt install gnuplot-nox"});
}

TEST_F(Cli, RefusesInTheSideViewWhatMakesNoSenseThere) {
  const std::string walk = "walk --robot genghis2d ";
  for (const char* option : {"--radius 3", "--spin cw", "--random-commands 3", "--no-contacts"})
    refuses(walk + option, {std::string(option).substr(0, 5), "genghis2d"});
  refuses(walk + "--crab 20deg", {"--crab", "'20deg'", "180deg"});
  refuses(walk + "--terrain boxes:0.1", {"boxes:0.1", "rough:H", "step:H"});
  refuses(walk + "--random-posture 0.2", {"--random-posture", "0.05"});
  refuses(walk + "--physics-step 0.003 --control-period 0.005", {"--control-period", "0.003"});
}

}  // namespace
}  // namespace hexagait::app
