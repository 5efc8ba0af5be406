// SPIR-V files as shaders: what they compute, what they tell of themselves, and what is wrong with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "ShaderLint.h"
#include "SpirvFile.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::AllOf;
using testing::HasSubstr;

const char* const Text =
	"RWTexture2D<float4> Out;\nByteAddressBuffer Bytes;\nfloat4 Scale;\n[numthreads(1, 1, 1)] void "
	"Main(uint3 Id : SV_DispatchThreadID)\n{\n\tuint Size;\n\tBytes.GetDimensions(Size);\n"
	"\tOut[Id.xy] = Scale * (float(Id.x) + Size);\n}\n";

/** The words of Text as the front end gives them. */
std::vector<uint32_t> MakeWords()
{
	const FShaderHarness Harness(Text, "Main", EShaderStage::Compute);
	return CompileToSpirv(FlattenShader(Harness.Request), Harness.Request);
}

std::string ToBytes(const std::vector<uint32_t>& Words)
{
	return {reinterpret_cast<const char*>(Words.data()), Words.size() * sizeof(uint32_t)};
}

std::string ErrorOfBytes(const std::string& Bytes, const std::string& Entry = "Main")
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Module.spv";
	Request.EntryPoint = Entry;
	return ErrorOf([&] { ReadSpirvFile(Bytes, Request); });
}

/** The same module with one more entry in front. */
std::vector<uint32_t> AddEntry(std::vector<uint32_t> Words)
{
	constexpr uint32_t OpEntryPoint = 15;
	for (size_t At = 5; At < Words.size(); At += Words[At] >> 16)
	{
		if ((Words[At] & 0xffff) == OpEntryPoint)
		{
			const std::vector<uint32_t> Other = {
				5u << 16 | OpEntryPoint, 4, Words[At + 2], 0x65687445u, 0x72u}; // "Ether"
			Words.insert(Words.begin() + std::ptrdiff_t(At), Other.begin(), Other.end());
			break;
		}
	}
	return Words;
}

const char* const CountingText = "AppendStructuredBuffer<uint> Kept;\n[numthreads(8, 1, 1)] void "
								 "Main(uint3 Id : SV_DispatchThreadID) { Kept.Append(Id.x * 2); }\n";

constexpr uint32_t OpName = 5;

std::string ReadName(const uint32_t* Instruction)
{
	return {reinterpret_cast<const char*>(Instruction + 2)}; // ends with a zero, as every string of SPIR-V
}

/** The module with another name for what has one, with or without the decoration that names counters. */
std::vector<uint32_t> Rename(
	const std::vector<uint32_t>& Words, const std::string& From, const std::string& To, bool bDecorated)
{
	constexpr uint32_t OpDecorateId = 332;
	std::vector<uint32_t> Result(Words.begin(), Words.begin() + 5);
	for (size_t At = 5; At < Words.size(); At += Words[At] >> 16)
	{
		const uint32_t Op = Words[At] & 0xffff;
		if (Op == OpName && ReadName(&Words[At]) == From)
		{
			std::vector<uint32_t> Text(To.size() / 4 + 1, 0);
			std::copy(To.begin(), To.end(), reinterpret_cast<char*>(Text.data()));
			Result.insert(Result.end(), {uint32_t(Text.size() + 2) << 16 | OpName, Words[At + 1]});
			Result.insert(Result.end(), Text.begin(), Text.end());
		}
		else if (Op != OpDecorateId || bDecorated)
		{
			const auto First = Words.begin() + std::ptrdiff_t(At);
			Result.insert(Result.end(), First, First + std::ptrdiff_t(Words[At] >> 16));
		}
	}
	return Result;
}

/** A folder that is mapped to /SpirvFileTest while a test runs. */
class FSpirvFileTest : public testing::Test
{
protected:
	FSpirvFileTest()
	{
		ForgetCompiledShaders(); // of the same path
		AddShaderDirectory("/SpirvFileTest", Folder.Path.string());
	}
	~FSpirvFileTest() override { ForgetShaderDirectories(NumDirectories); }

	FShaderHarness MakeHarness(const std::vector<uint32_t>& Words)
	{
		Folder.Add("Module.spv", ToBytes(Words));
		FShaderHarness Harness("", "Main", EShaderStage::Compute);
		Harness.Request.VirtualPath = "/SpirvFileTest/Module.spv";
		Harness.Request.GeneratedFiles.clear();
		Harness.Textures["Out"] = FTestTexture(3, 1);
		Harness.Buffers["Bytes"] = {1, 2};
		Harness.SetFloats("Scale", {1, 2, 3, 4});
		return Harness;
	}

	const size_t NumDirectories = CountShaderDirectories();
	const FScratchFolder Folder;
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", (Folder.Path / "cache").string()};
};

} // namespace

TEST_F(FSpirvFileTest, RunsAsTheHlslThatItWasMadeOf)
{
	FShaderHarness Harness = MakeHarness(MakeWords());
	for (const int32_t Lanes : GetLaneCounts())
	{
		Harness.Textures["Out"] = FTestTexture(3, 1);
		Harness.Run(Lanes, 3, 1);
		for (int32_t X = 0; X < 3; ++X)
		{
			for (int32_t c = 0; c < 4; ++c)
			{
				EXPECT_EQ(float((c + 1) * (X + 8)), Harness.Textures["Out"].Texel(X, 0)[c]); // 2 words are 8 bytes
			}
		}
	}
}

TEST_F(FSpirvFileTest, CountersAreFoundByTheNamesAndTheDecorationOfFrontEnds)
{
	const FShaderHarness Source(CountingText, "Main", EShaderStage::Compute);
	const std::vector<uint32_t> Words = CompileToSpirv(FlattenShader(Source.Request), Source.Request);
	const std::string Glslang = "Kept@count";
	const std::vector<std::pair<std::string, std::vector<uint32_t>>> Modules = {
		{Glslang, Rename(Words, Glslang, Glslang, false)},
		{"counter.var.Kept", Rename(Words, Glslang, "counter.var.Kept", false)},
		{"Other", Rename(Words, Glslang, "Other", true)}};
	for (const auto& [Name, Module] : Modules)
	{
		FShaderHarness Harness = MakeHarness(Module);
		Harness.Buffers["Kept"].assign(8, 0);
		Harness.Buffers[Name] = {0};
		ForgetCompiledShaders();
		const std::shared_ptr<const FCompiledShader> Shader = Harness.Run(4, 8, 1);
		EXPECT_EQ((std::vector<uint32_t>{0, 2, 4, 6, 8, 10, 12, 14}), Harness.Buffers["Kept"]) << Name;
		EXPECT_EQ(8u, Harness.Buffers[Name][0]);
		for (const FShaderResource& Resource : Shader->Reflection.RWBuffers)
		{
			EXPECT_EQ(Resource.Name == Name ? "Kept" : "", Resource.CounterOf);
			// By the HLSL that the module carries.
			EXPECT_EQ(Resource.Name == Name ? EShaderCounter::Append : EShaderCounter::Any, Resource.Counter);
		}
	}
	FShaderHarness Unnamed = MakeHarness(Rename(Words, Glslang, "Other", false));
	ForgetCompiledShaders();
	EXPECT_THAT(ErrorOf([&] { CompileShader(Unnamed.Request); }), HasSubstr("buffer 'Other' is of a kind that"));
}

TEST_F(FSpirvFileTest, ANewFileIsAnotherShader)
{
	FShaderHarness Harness = MakeHarness(MakeWords());
	const std::string Key = CompileShader(Harness.Request)->Key;
	const FShaderHarness Other("RWTexture2D<float4> Out;\n[numthreads(1, 1, 1)] void Main() { Out[int2(0, 0)] = 1; }",
		"Main", EShaderStage::Compute);
	Folder.Add("Module.spv", ToBytes(CompileToSpirv(FlattenShader(Other.Request), Other.Request)));
	ForgetCompiledShaders();
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Harness.Request);
	EXPECT_NE(Key, Shader->Key);
	EXPECT_EQ(0u, Shader->Reflection.Buffers.size());
	EXPECT_THAT(Shader->Files, testing::ElementsAre((Folder.Path / "Module.spv").string()));
}

TEST_F(FSpirvFileTest, TheEntryThatIsAskedForIsTakenOfSeveral)
{
	FShaderHarness Harness = MakeHarness(AddEntry(MakeWords()));
	EXPECT_EQ(1u, ReflectShader(Harness.Request).RWTextures.size());
	EXPECT_THAT(ErrorOfBytes(ToBytes(AddEntry(MakeWords())), "Nothing"),
		HasSubstr("/Test/Module.spv: error DD6011: entry point 'Nothing' (compute) is not in this module; it has Ether "
				  "(pixel), Main (compute)"));
}

TEST_F(FSpirvFileTest, LintFindsTheEntriesOfAModule)
{
	const FShaderHarness Harness = MakeHarness(AddEntry(MakeWords()));
	FShaderCompileRequest Request = Harness.Request;
	Request.EntryPoint = "";
	std::vector<std::string> Entries;
	for (const FShaderEntry& Entry : FindShaderEntries(Request))
	{
		Entries.push_back(Entry.Name + (Entry.Stage == EShaderStage::Pixel ? " pixel" : " other"));
	}
	EXPECT_THAT(Entries, testing::ElementsAre("Ether pixel", "Main other"));
	Request.EntryPoint = "Main";
	std::vector<FDiagnostic> Refused;
	LintShader(Request, 0xFF, &Refused);
	EXPECT_TRUE(Refused.empty());

	Folder.Add("Module.spv", "no module");
	EXPECT_THAT(ErrorOf([&] { FindShaderEntries(Request); }), HasSubstr("DD6004"));
}

TEST_F(FSpirvFileTest, AFileThatIsMissingIsNamed)
{
	FShaderHarness Harness = MakeHarness(MakeWords());
	Harness.Request.VirtualPath = "/SpirvFileTest/Modul.spv";
	EXPECT_THAT(ErrorOf([&] { ReflectShader(Harness.Request); }),
		AllOf(HasSubstr("cannot open shader '/SpirvFileTest/Modul.spv'"),
			HasSubstr("did you mean /SpirvFileTest/Module.spv?")));
}

TEST(SpirvFile, WhatIsNoModuleIsRefused)
{
	const std::string Good = ToBytes(MakeWords());
	EXPECT_EQ("", ErrorOfBytes(Good));
	EXPECT_THAT(ErrorOfBytes(Good.substr(0, 30)), HasSubstr("error DD6004: this file is not SPIR-V: it has 30 bytes"));
	EXPECT_THAT(ErrorOfBytes(""), HasSubstr("it has 0 bytes"));
	EXPECT_THAT(ErrorOfBytes("float4 Main() {     }"
							 "   "),
		HasSubstr("does not begin with 0x07230203"));
	std::string Swapped = Good;
	std::swap(Swapped[0], Swapped[3]);
	std::swap(Swapped[1], Swapped[2]);
	EXPECT_THAT(ErrorOfBytes(Swapped), HasSubstr("bytes in the other order"));
	std::string Cut = Good;
	Cut[Cut.size() - 1] = 9; // the last instruction is longer than the file
	Cut[Cut.size() - 2] = 9;
	EXPECT_THAT(ErrorOfBytes(Cut), HasSubstr("is cut short"));
}
