// Shots: ranges, what a number is at a frame, and what is refused.
#include "scene/frames.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/read_scene.h"
#include "scene/shot.h"

namespace shatterpave::scene {
namespace {

std::vector<int> frames(std::string_view range) { return frames_of_range(range, Place{"here", 0, 0, ""}); }

std::string refusal_of_range(std::string_view range) {
  try {
    frames(range);
    return "";
  } catch (const InputError& error) {
    return error.message();
  }
}

TEST(FrameRange, IsReadAsItIsWritten) {
  EXPECT_EQ(frames("1-4"), (std::vector{1, 2, 3, 4}));
  EXPECT_EQ(frames("1-10:3"), (std::vector{1, 4, 7, 10}));
  EXPECT_EQ(frames("2-10:3"), (std::vector{2, 5, 8}));
  EXPECT_EQ(frames("1,5,9-12"), (std::vector{1, 5, 9, 10, 11, 12}));
  EXPECT_EQ(frames("9-12,5,1,10"), (std::vector{1, 5, 9, 10, 11, 12}));  // any order, each once
  EXPECT_EQ(frames("7-7"), (std::vector{7}));
  EXPECT_EQ(frames("0"), (std::vector{0}));
  EXPECT_EQ(frames("0007"), (std::vector{7}));
  EXPECT_EQ(frames("9999990-9999999:9"), (std::vector{9999990, 9999999}));
  EXPECT_EQ(frames("1-100000").size(), most_frames);
}

TEST(FrameRange, IsRefusedInWords) {
  const std::string expected = "expected frames such as 1-10, 1-10:2 or 1,5,9-12, each from 0 to 9999999, got ";
  for (const char* const range : {"", "a", "1-", "1-2-3", "1,", ",1", "1-5:0", "1-5:", "5:2", "1 - 5", "1..5", "10000000",
                                  "1-5:x", "99999999999999999999", "1-5x2", "+3", "1e3", " 1"}) {
    EXPECT_EQ(refusal_of_range(range), fmt::format("{}\"{}\"", expected, range)) << range;
  }
  for (const char* const range : {"-5", "-5--1", "1--3", "3,-1"}) {
    EXPECT_EQ(refusal_of_range(range), fmt::format("{}\"{}\", with a negative frame", expected, range)) << range;
  }
  EXPECT_EQ(refusal_of_range("10-1"), "expected the first frame of a range before its last, got \"10-1\"; did you mean 1-10?");
  EXPECT_EQ(refusal_of_range("1-100001"), "expected at most 100000 frames, got more: \"1-100001\"");
  EXPECT_EQ(refusal_of_range("1-60000,100000-160000"), "expected at most 100000 frames, got more: \"1-60000,100000-160000\"");
}

TEST(FrameRange, IsWrittenAsShortAsItCanBe) {
  for (const char* const range : {"1-4", "7", "1,3", "1-2,4-6,9", "0-1,9999999"}) EXPECT_EQ(range_text(frames(range)), range);
  EXPECT_EQ(frame_digits(7), "0007");
  EXPECT_EQ(frame_digits(12345), "12345");
}

FrameKey key(Ease ease) { return {"x", {{10, {1.0, -4.0}}, {20, {2.0, -4.0}}, {24, {0.1, 4.0}}}, ease, true, false, {}}; }

TEST(FrameKeys, RunFromStopToStop) {
  const FrameKey even = key(Ease::linear);
  for (const int before : {0, 9, 10}) EXPECT_EQ(value_at(even, before), (std::vector{1.0, -4.0}));
  EXPECT_EQ(value_at(even, 15), (std::vector{1.5, -4.0}));
  EXPECT_EQ(value_at(even, 20), (std::vector{2.0, -4.0}));
  EXPECT_EQ(value_at(even, 22), (std::vector{0.5 * 2.0 + 0.5 * 0.1, 0.0}));
  for (const int after : {24, 25, 9999}) EXPECT_EQ(value_at(even, after), (std::vector{0.1, 4.0}));
  const FrameKey smooth = key(Ease::smooth);
  const double t = 0.2;  // of frame 12
  EXPECT_DOUBLE_EQ(value_at(smooth, 12)[0], 1.0 + 3 * t * t - 2 * t * t * t);
  EXPECT_EQ(value_at(smooth, 15)[0], 1.5);
  EXPECT_LT(value_at(smooth, 11)[0], value_at(even, 11)[0]);  // at rest at its stops
  EXPECT_GT(value_at(smooth, 19)[0], value_at(even, 19)[0]);
}

TEST(FrameKeys, RoundWhereWholeNumbersAreTaken) {
  FrameKey whole = key(Ease::linear);
  whole.is_whole = true;
  EXPECT_EQ(value_at(whole, 12), (std::vector{1.0, -4.0}));
  EXPECT_EQ(value_at(whole, 16), (std::vector{2.0, -4.0}));
}

constexpr std::string_view things = R"(
[[pane]]
name = "window"
size_mm = [300, 200]
place_mm = [0, 0, 100]
[[pane.impact]]
at_mm = [150, 100]
radial_count = 9
[[pavement]]
name = "path"
size_mm = [1000, 800]
joint_mm = 8
[camera]
at_mm = [0, -3000, 1600]
look_at_mm = [0, 0, 0]
)";

std::string shot_text(std::string_view keys, std::string_view range = "1-48") {
  return fmt::format("{}[frames]\nrange = \"{}\"\n{}", things, range, keys);
}

// What is said to a shot when it is read, or when all of its frames are.
std::string refusal_of(const std::string& text) {
  try {
    Shot shot(Draft(text, "yard.toml"));
    shot.require_all();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string with_key(std::string_view set, std::string_view at, std::string_view more = "") {
  return shot_text(fmt::format("[[frames.key]]\nset = \"{}\"\nat = {}\n{}", set, at, more));
}

TEST(Shot, SetsNumbersListsAndElements) {
  Shot shot(Draft(shot_text("key = [{set = \"camera.at_mm\", at = [[1, [0, -3000, 1600]], [5, [400, -3000, 800]]]},\n"
                            "{set = \"pavement.path.joint_mm\", at = [[1, 4], [5, 12]], ease = \"smooth\"},\n"
                            "{set = \"pane[0].impact[0].at_mm[0]\", at = [[1, 100], [5, 200]]},\n"
                            "{set = \"pane.window.impact[0].radial_count\", at = [[1, 8], [5, 11]]},\n"
                            "{set = \"light.exposure_ev\", at = [[3, 1]]}]\n"),
                  "yard.toml"));
  EXPECT_EQ(shot.still().camera->at_mm, vec3(0.0, -3000.0, 1600.0));
  EXPECT_EQ(shot.still().pavements[0].joint_mm, 8.0);  // keys have no effect on the still
  EXPECT_FALSE(shot.still().light.has_value());
  const Scene middle = shot.at(3);
  EXPECT_EQ(middle.camera->at_mm, vec3(200.0, -3000.0, 1200.0));
  EXPECT_EQ(middle.pavements[0].joint_mm, 8.0);
  EXPECT_EQ(middle.panes[0].impacts[0].at_mm, vec2(150.0, 100.0));
  EXPECT_EQ(middle.panes[0].impacts[0].radial_count, 10);  // 9.5, rounded
  EXPECT_EQ(middle.light->exposure_ev, 1.0);
  EXPECT_EQ(shot.at(1).pavements[0].joint_mm, 4.0);
  EXPECT_EQ(shot.at(2).pavements[0].joint_mm, 4.0 + 8.0 * (3.0 / 16.0 - 2.0 / 64.0));
  EXPECT_EQ(shot.at(1), shot.at(1));  // also after other frames
}

// A frame is what the scene with these values is; what frames share has the same sums.
TEST(Shot, FramesAreScenes) {
  Shot shot(Draft(with_key("camera.at_mm[2]", "[[1, 1600.5], [3, 800.5]]"), "yard.toml"));
  const Scene second = shot.at(2);
  Scene same = scene_of_text(things, "yard.toml", {{"--set", "camera.at_mm[2]", "1200.5"}});
  EXPECT_EQ(second.fingerprint, same.fingerprint);
  same.frames = second.frames;
  EXPECT_EQ(second, same);
  EXPECT_NE(shot.at(1).fingerprint, second.fingerprint);
  EXPECT_EQ(shot.at(3).fingerprint, shot.at(48).fingerprint);
  EXPECT_EQ(shot.at(1).pane_sums, second.pane_sums);
  EXPECT_EQ(shot.at(1).pavement_sums, second.pavement_sums);
  EXPECT_EQ(second.pane_sums.size(), 1U);
  EXPECT_EQ(second.pavement_sums.size(), 1U);
}

TEST(Shot, SumsTellWhichThingsChange) {
  const auto changes = [](const std::string& set, const std::string& at) {
    Shot shot(Draft(with_key(set, at), "yard.toml"));
    const Scene first = shot.at(1);
    const Scene last = shot.at(48);
    return std::pair(first.pane_sums != last.pane_sums, first.pavement_sums != last.pavement_sums);
  };
  EXPECT_EQ(changes("light.exposure_ev", "[[1, 0], [48, 2]]"), std::pair(false, false));
  EXPECT_EQ(changes("pane.window.place_mm", "[[1, [0, 0, 0]], [48, [9, 9, 9]]]"), std::pair(false, false));
  EXPECT_EQ(changes("pane.window.thickness_mm", "[[1, 2], [48, 3]]"), std::pair(true, false));
  EXPECT_EQ(changes("pavement.path.joint_mm", "[[1, 2], [48, 3]]"), std::pair(false, true));
  EXPECT_EQ(changes("seed", "[[1, 2], [48, 3]]"), std::pair(true, true));
}

TEST(Shot, RefusesPathsOfNoNumber) {
  EXPECT_EQ(refusal_of(with_key("camera.att_mm", "[[1, 2]]")),
            "yard.toml:20:6: frames.key[0].at: frame 1: camera.att_mm: unknown key; did you mean at_mm?");
  EXPECT_EQ(refusal_of(with_key("pane.windoe.thickness_mm", "[[1, 2]]")),
            "yard.toml:20:6: frames.key[0].at: frame 1: expected pane[0] or pane.window, got \"windoe\"; did you mean "
            "pane.window?");
  EXPECT_EQ(
      refusal_of(with_key("pane.window.glass", "[[1, 2]]")),
      "yard.toml:19:7: frames.key[0].set: expected the path of a number of the scene, got \"pane.window.glass\", which is "
      "one of several words");
  EXPECT_NE(refusal_of(with_key("pane.window.name", "[[1, 2]]")).find("which is a text"), std::string::npos);
  EXPECT_NE(refusal_of(with_key("still.caustics", "[[1, 1]]")).find("which is true or false"), std::string::npos);
  EXPECT_NE(refusal_of(with_key("camera", "[[1, 1]]")).find("which is a table"), std::string::npos);
  EXPECT_NE(refusal_of(with_key("pane.window", "[[1, 1]]")).find("which is a table"), std::string::npos);
  EXPECT_NE(refusal_of(with_key("frames.per_second", "[[1, 1]]")).find("which is of the frames themselves"), std::string::npos);
  EXPECT_NE(refusal_of(with_key("camera.at_mm[3]", "[[1, 1]]")).find("frame 1: expected "), std::string::npos);
  EXPECT_NE(refusal_of(with_key("camera..at_mm", "[[1, 1]]")).find("expected a key such as"), std::string::npos);
}

TEST(Shot, RefusesValuesAtAnyFrame) {
  EXPECT_EQ(refusal_of(with_key("pavement.path.joint_mm", "[[1, 2], [48, 4000]]")).substr(0, 81),
            "yard.toml:20:6: frames.key[0].at: frame 13: pavement[0].joint_mm: expected a numb");
  EXPECT_EQ(refusal_of(with_key("pavement.path.joint_mm", "[[1, 2], [48, 20]]")), "");
  // Between two stops that are taken: within the glass.
  EXPECT_NE(refusal_of(with_key("camera.at_mm", "[[1, [150, -1000, 200]], [21, [150, 1000, 200]]]"))
                .find("frame 11: camera.at_mm: expected a camera outside the glass"),
            std::string::npos);
  EXPECT_NE(refusal_of(with_key("camera.at_mm", "[[1, 5]]")).find("frame 1: camera.at_mm: expected a place"),
            std::string::npos);
  EXPECT_NE(refusal_of(with_key("camera.at_mm", "[[1, [1, 2]]]")).find("frame 1: camera.at_mm: expected"), std::string::npos);
}

TEST(Shot, RefusesWhatIsNoShot) {
  const auto said = [](const std::string& text, std::string_view what) {
    return refusal_of(text).find(what) != std::string::npos ? "" : refusal_of(text);
  };
  EXPECT_EQ(said(with_key("camera.at_mm", "[[5, 1], [5, 2]]"), "expected a frame after 5, got 5"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[5, 1], [4, 2]]"), "expected a frame after 5, got 4"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[-1, 1]]"), "expected a frame, a whole number from 0 to 9999999, got -1"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[1.5, 1]]"), "expected a frame"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[]"), "expected stops [[frame, value], …]"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[1, 2]"), "expected [frame, value], got 1"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[1, \"x\"]]"), "got the text"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[1, nan]]"), "expected a number"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[1, inf]]"), "expected a number"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[1, 2], [3, [1]]]"), "expected values alike at all frames"), "");
  EXPECT_EQ(said(with_key("camera.at_mm", "[[1, [1, 2, 3]], [3, [1, 2]]]"), "expected values alike at all frames"), "");
  EXPECT_EQ(said(with_key("camera.focus_mm", "[[1, 2]]", "ease = \"linar\""), "did you mean \"linear\"?"), "");
  EXPECT_EQ(said(with_key("camera.focus_mm", "[[1, 2]]", "[[frames.key]]\nset = \"camera.focus_mm\"\nat = [[1, 2]]"),
                 "another of \"camera.focus_mm\""),
            "");
  EXPECT_EQ(said(shot_text("[[frames.key]]\nset = \"seed\"\n"), "expected stops"), "");
  EXPECT_EQ(said(shot_text("[[frames.key]]\nat = [[1, 2]]\n"), "expected the path of a number"), "");
  EXPECT_EQ(said(shot_text("", "1-10:2"), "expected a range without gaps"), "");
  EXPECT_EQ(said(shot_text("", "5-1"), "did you mean 1-5?"), "");
  EXPECT_EQ(said(std::string(things) + "[frames]\n", "expected the range of the shot"), "");
  EXPECT_EQ(said(shot_text("per_second = 0\n"), "expected a number from 1 to 1000, got 0"), "");
}

}  // namespace
}  // namespace shatterpave::scene
