// Shaders on a Vulkan driver as a user asks for it: --backend, r.Drydock.Backend, a study of both, and what is said
// where there is no driver or it cannot run a shader.
#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ProgramTestUtils.h"
#include "rdg/vulkan/VulkanManifests.h"

#include <cmath>
#include <optional>

using Drydock::Test::FScopedVulkanDriver;
using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** Bloom has shaders that no hand-written kernel stands for. */
const std::string Bloom = R"(, "volumes": [{"bUnbound": true, "Settings": {"BloomIntensity": 1}}])";
const std::string OnlyShaders = " --set r.Drydock.NativeKernels=0";
const char* const Nowhere = DRYDOCK_TEST_BINARY_DIR "/no_driver.json";

class BackendProgram : public testing::Test
{
protected:
	std::vector<float> ReadPicture(const std::string& Out) const
	{
		Drydock::FImageFile File((Folder.Path / Out / "final.exr").string());
		std::vector<float> All;
		for (const char* const Channel : {"R", "G", "B"})
		{
			const std::vector<float> Plane = File.Read({File.FindChannel(Channel)})[0];
			All.insert(All.end(), Plane.begin(), Plane.end());
		}
		return All;
	}

	nlohmann::json GetReport(const std::string& Out) const
	{
		return nlohmann::json::parse(Folder.Read(Out + "/run.json"));
	}

	const FProgramFolder Folder{"backend"};
};

/** The first driver of a CPU that is here. */
std::optional<std::string> FindDriver()
{
	for (const Drydock::Test::FVulkanManifest& Known : Drydock::Test::GetVulkanManifests())
	{
		if (const std::optional<std::string> Manifest = Known.Find())
		{
			return Manifest;
		}
	}
	return std::nullopt;
}

/** Its driver is what drydock finds; without one its tests are skipped. */
class BackendOnADriver : public BackendProgram
{
protected:
	void SetUp() override
	{
		if (!Driver)
		{
			GTEST_SKIP() << "no Vulkan driver of a CPU is here (Debian packages mesa-vulkan-drivers, chromium)";
		}
	}

private:
	const std::optional<std::string> Driver = FindDriver();
	const FScopedVulkanDriver Chosen{Driver.value_or(Nowhere)};
};

} // namespace

TEST_F(BackendOnADriver, VulkanMakesTheSamePicture)
{
	Folder.WriteFrame("a.json", Bloom);
	const FOutcome OnCpu = Folder.Call("run a.json --out cpu" + OnlyShaders);
	ASSERT_EQ(0, OnCpu.ExitCode) << OnCpu.Printed;
	const FOutcome OnDevice = Folder.Call("run a.json --backend vulkan --out vulkan" + OnlyShaders);
	ASSERT_EQ(0, OnDevice.ExitCode) << OnDevice.Printed;
	EXPECT_FALSE(GetReport("cpu").contains("device"));
	const std::string Device = GetReport("vulkan")["device"];
	EXPECT_THAT(OnDevice.Printed, HasSubstr("shaders on " + Device));
	EXPECT_THAT(OnDevice.Printed, Not(HasSubstr("DD6071")));
	const std::vector<float> Cpu = ReadPicture("cpu");
	const std::vector<float> Vulkan = ReadPicture("vulkan");
	ASSERT_EQ(Cpu.size(), Vulkan.size());
	for (size_t i = 0; i < Cpu.size(); ++i)
	{
		ASSERT_NEAR(Cpu[i], Vulkan[i], 1 / 255.0f) << i; // a step of the display's 8 bits
	}
}

TEST_F(BackendProgram, AConfigMayAskForItAndTheCommandLineTakeItBack)
{
	const FScopedVulkanDriver None(Nowhere);
	Folder.WriteFrame("a.json", Bloom + R"(, "cvars": {"r.Drydock.Backend": 1})");
	const FOutcome Asked = Folder.Call("run a.json --out asked" + OnlyShaders);
	EXPECT_EQ(2, Asked.ExitCode);
	EXPECT_THAT(Asked.Printed, HasSubstr("DD6070"));
	const FOutcome TakenBack = Folder.Call("run a.json --backend cpu --out cpu" + OnlyShaders);
	EXPECT_EQ(0, TakenBack.ExitCode) << TakenBack.Printed;
}

TEST_F(BackendProgram, WithoutADriverOneMessageSaysSoAndNothingIsWritten)
{
	const FScopedVulkanDriver None(Nowhere);
	Folder.WriteFrame("a.json", Bloom);
	const FOutcome Outcome = Folder.Call("run a.json --backend vulkan --out out");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("DD6070"));
	EXPECT_THAT(Outcome.Printed, HasSubstr("shaders cannot run on Vulkan: "));
	EXPECT_EQ(Outcome.Printed.find("DD6070"), Outcome.Printed.rfind("DD6070"));
	EXPECT_FALSE(ProgramTest::Files::exists(Folder.Path / "out"));
}

TEST_F(BackendProgram, AMisspeltBackendHasANearestName)
{
	Folder.WriteFrame("a.json", "");
	const FOutcome Outcome = Folder.Call("run a.json --backend vulcan --out out");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_THAT(Outcome.Printed, HasSubstr("--backend: \"vulcan\" is not one of cpu, vulkan; did you mean vulkan?"));
	EXPECT_FALSE(ProgramTest::Files::exists(Folder.Path / "out"));
}

TEST_F(BackendOnADriver, AShaderThatTheDeviceCannotRunIsNamedAndRunsOnTheCpu)
{
	Folder.WriteFrame("a.json", Bloom);
	const std::string Double = " --precision double" + OnlyShaders;
	const FOutcome Outcome = Folder.Call("run a.json --backend vulkan --out vulkan" + Double);
	ASSERT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	EXPECT_THAT(Outcome.Printed, HasSubstr("DD6071"));
	EXPECT_THAT(Outcome.Printed, HasSubstr(" runs on the CPU and not on "));
	EXPECT_THAT(Outcome.Printed, HasSubstr(": it has no textures in double precision"));
	ASSERT_EQ(0, Folder.Call("run a.json --out cpu" + Double).ExitCode);
	EXPECT_EQ(ReadPicture("cpu"), ReadPicture("vulkan"));
}

TEST_F(BackendOnADriver, AStudyHasItAsAVariant)
{
	Folder.WriteFrame("a.json", Bloom + R"(, "cvars": {"r.Drydock.NativeKernels": 0},
		"study": {"axes": [{"name": "r.Drydock.Backend", "values": [0, 1]}], "repetitions": 1})");
	const FOutcome Outcome = Folder.Call("study a.json --out out");
	ASSERT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
	const nlohmann::json Study = nlohmann::json::parse(Folder.Read("out/study.json"));
	const nlohmann::json& Variants = Study["jobs"][0]["variants"];
	ASSERT_EQ(2u, Variants.size());
	for (const nlohmann::json& Variant : Variants)
	{
		EXPECT_LT(Variant["rms"].get<double>(), 1 / 255.0) << Variant;
	}
	// Its numbers are a driver's: near the kernels', not theirs.
	EXPECT_NE(Variants[0]["rms"], Variants[1]["rms"]);
}
