// Job files, what they book, and the sidecars of frames.
#include "pipeline/farm.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "pipeline/frame_sidecar.h"

namespace shatterpave::pipeline {
namespace {

FarmJob job() {
  FarmJob result{"yard", "scenes/yard.toml", "out", {{"--set a", "pane.it's.thickness_mm", "3"}}, {1, 2, 3, 4, 5, 9, 10}, {}};
  result.options.width = 640;
  result.options.height = 480;
  return result;
}

MeasuredFrame measured(double seconds, double renderer, double processors, std::int64_t memory) {
  return {3, {320, 240}, {seconds, renderer, processors, memory}};
}

TEST(Farm, ChunksHaveNoGaps) {
  EXPECT_EQ(farm_chunks({1, 2, 3, 4, 5, 9, 10}, 2), (std::vector<std::string>{"1-2", "3-4", "5", "9-10"}));
  EXPECT_EQ(farm_chunks({1, 2, 3, 4, 5, 9, 10}, 100), (std::vector<std::string>{"1-5", "9-10"}));
  EXPECT_EQ(farm_chunks({7, 8}, 1), (std::vector<std::string>{"7", "8"}));
}

// By hand: the frame has four times the pixels of the measured one; four threads.
TEST(Farm, BooksByPixelsQualityAndProcessors) {
  const FarmNeeds draft = farm_needs(job(), measured(7.0, 5.0, 8.0, 400 * 1024), 5);
  EXPECT_EQ(draft.threads, 4);
  EXPECT_DOUBLE_EQ(draft.frame_seconds, 8.0 * 4.0 / 4.0);
  EXPECT_DOUBLE_EQ(draft.start_seconds, 2.0);
  EXPECT_EQ(draft.chunk, 5);
  EXPECT_EQ(draft.task_seconds, 300);  // 2 × (2 + 5 × 8) is less than the least
  EXPECT_EQ(draft.memory_mib, 768);    // 1.5 × (400 + 128 × 230,400 / 2^20) = 642, in steps of 256
  FarmJob final = job();
  final.options.quality = Quality::final;
  final.options.threads = 2;
  const FarmNeeds needs = farm_needs(final, measured(7.0, 5.0, 8.0, 400 * 1024), 5);
  EXPECT_DOUBLE_EQ(needs.frame_seconds, 10.0 * 8.0 * 4.0 / 2.0);
  EXPECT_EQ(needs.task_seconds, 1620);                                   // 2 × (2 + 5 × 160) = 1604, in minutes
  EXPECT_EQ(farm_needs(job(), measured(0.2, 0.1, 0.1, 1), 0).chunk, 7);  // all
  EXPECT_EQ(farm_needs(final, measured(7.0, 5.0, 4.0, 1), 0).chunk, 3);  // 80 s each, 300 s in all
  EXPECT_EQ(farm_needs(final, measured(900.0, 500.0, 800.0, 1), 0).chunk, 1);
}

TEST(Farm, MeasuresSmallDraftsOfTheFramesShape) {
  RenderOptions options;
  options.quality = Quality::final;
  options.width = 1920;
  options.height = 1080;
  const RenderOptions small = measured_options(options);
  EXPECT_EQ(small.quality, Quality::draft);
  EXPECT_EQ(small.width, 320);
  EXPECT_EQ(small.height, 180);
  options.width = 100;
  options.height = 1;
  EXPECT_EQ(measured_options(options).width, 100);
  EXPECT_EQ(measured_options(options).height, 1);
}

FarmNeeds needs(int chunk) { return {2, chunk, 10.0, 1.0, 3720, 512}; }

TEST(Farm, SlurmIsGivenAnArray) {
  const std::string text = farm_file(FarmSystem::slurm, job(), needs(2)).content;
  for (const char* const line :
       {"#SBATCH --job-name=\"yard\"\n", "#SBATCH --array=0-3\n", "#SBATCH --cpus-per-task=2\n", "#SBATCH --mem=512M\n",
        "#SBATCH --time=1:02:00\n", "#SBATCH --requeue\n", "#SBATCH --signal=B:TERM@60\n",
        "#SBATCH --output=\"out/yard.%A_%a.log\"\n", "\nchunks=(1-2 3-4 5 9-10)\nframes=${chunks[SLURM_ARRAY_TASK_ID]}\n",
        "render 'scenes/yard.toml' -o 'out' --frames \"$frames\" --quality 'draft' --size '640x480' --set "
        "'pane.it'\\''s.thickness_mm=3' --skip-existing --threads \"${SLURM_CPUS_PER_TASK:-2}\" --progress lines\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  // Of a frame a task, the task's number is the frame's, as far as sites have such numbers.
  FarmJob far = job();
  EXPECT_NE(farm_file(FarmSystem::slurm, far, needs(1)).content.find("#SBATCH --array=1-5,9-10\n"), std::string::npos);
  EXPECT_NE(farm_file(FarmSystem::slurm, far, needs(1)).content.find("\nframes=$SLURM_ARRAY_TASK_ID\n"), std::string::npos);
  far.frames = {1000, 1001};
  EXPECT_NE(farm_file(FarmSystem::slurm, far, needs(1)).content.find("chunks=(1000 1001)"), std::string::npos);
  far.output = "100%";
  EXPECT_NE(farm_file(FarmSystem::slurm, far, needs(1)).content.find("\"100%%/yard.%A_%a.log\""), std::string::npos);
}

TEST(Farm, OpenJobDescriptionIsGivenATemplate) {
  const exporting::OutputFile file = farm_file(FarmSystem::openjd, job(), needs(2));
  EXPECT_EQ(file.name, "yard.openjd.yaml");
  for (const char* const line :
       {"\nname: \"yard\"\n", "name: Frames, type: STRING, default: \"1-5,9-10\"", "{name: amount.worker.vcpu, min: 2}",
        "{name: amount.worker.memory, min: 512}", "chunks: {defaultTaskCount: 2, rangeConstraint: CONTIGUOUS}",
        "- \"{{Task.Param.Frame}}\"\n", "- \"pane.it's.thickness_mm=3\"\n", "timeout: 3720\n",
        "cancelation: {mode: NOTIFY_THEN_TERMINATE, notifyPeriodInSeconds: 60}"}) {
    EXPECT_NE(file.content.find(line), std::string::npos) << line << file.content;
  }
  FarmJob odd = job();
  odd.overrides[0].value = "{{x}}";
  EXPECT_THROW(farm_file(FarmSystem::openjd, odd, needs(2)), InputError);
}

TEST(Farm, ParallelIsGivenChunks) {
  const exporting::OutputFile file = farm_file(FarmSystem::parallel, job(), needs(3));
  EXPECT_EQ(file.name, "yard.parallel.sh");
  for (const char* const line :
       {"--joblog 'out/yard.joblog' --resume-failed", "--memfree 512M", " --frames {} ", "\n  ::: 1-3 4-5 9-10\n"}) {
    EXPECT_NE(file.content.find(line), std::string::npos) << line << file.content;
  }
}

TEST(FrameSidecar, IsReadAsItWasWritten) {
  const FrameRecord record{{"1.2.3", "yard", "abc", 18446744073709551615U, 12345, "final", 1920, 1080},
                           {{"yard.12345.exr", 5'000'000'000U, "ff"}, {"yard.12345.png", 0, "00"}},
                           {61.2504, 58.9, 230.0, 412000}};
  EXPECT_EQ(sidecar_name("yard", 12345), "yard.12345.frame.json");
  EXPECT_EQ(frame_stem("yard", 7), "yard.0007");
  const std::string text = sidecar_text(record);
  const auto read = record_of(text);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->origin, record.origin);
  EXPECT_EQ(read->origin.scene, "yard");
  EXPECT_EQ(read->files, record.files);
  EXPECT_EQ(read->cost.seconds, 61.25);
  EXPECT_EQ(read->cost.most_memory_kib, 412000);
  for (std::size_t end = 0; end + 2 < text.size(); ++end) EXPECT_FALSE(record_of(text.substr(0, end))) << end;
  std::string other = text;
  other.replace(other.find("\"version\": 1"), 12, "\"version\": 2");
  EXPECT_FALSE(record_of(other));
  EXPECT_FALSE(record_of("[]"));
  EXPECT_FALSE(record_of("\xff"));
}

}  // namespace
}  // namespace shatterpave::pipeline
