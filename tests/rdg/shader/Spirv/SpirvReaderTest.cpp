// The reader against garbage: whatever the words, either a module that all later stages can walk, or an error.
#include <gtest/gtest.h>

#include "SpirvEmit.h"
#include "rdg/shader/Compiler/ShaderHarness.h"

#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

const std::vector<uint32_t>& GetWords()
{
	static const std::vector<uint32_t> Words = []
	{
		const std::string Text =
			"Texture2D T; SamplerState S; float4 A[4]; float4x4 M; int K; StructuredBuffer<float4> B;\n"
			"static const float W[3] = { 0.25, 0.5, 0.25 };\n"
			"float4 F(float2 UV, int n) { float4 s = 0; for (int i = 0; i < n; ++i) { if (UV.x > 0.5 * i) return s; if "
			"(i == 3) continue; s += W[i % 3] * T.SampleLevel(S, UV, 0) * A[i % 4]; } return s; }\n"
			"void Main(float4 P : SV_POSITION, float2 UV : TEXCOORD0, out float4 O : SV_Target0)\n"
			"{ float f[4] = { 1, 2, 3, P.x }; f[K % 4] = P.y; switch (K) { case 0: O = F(UV, 3); break; case 1: O = "
			"mul(P, M); break; default: O = B[K] + f[(K + 1) % 4]; } if (O.x < 0) discard; }\n";
		FShaderHarness Harness(Text, "Main", EShaderStage::Pixel);
		return CompileToSpirv(FlattenShader(Harness.Request), Harness.Request);
	}();
	return Words;
}

/** Everything that the compiler does with a module short of running it. */
bool Walk(const std::vector<uint32_t>& Words)
{
	try
	{
		const FSpirvModule Module = ReadSpirv(Words);
		const FSpirvStructure Structure = BuildSpirvStructure(Module);
		const FSpirvReflection Reflection = ReflectSpirv(Module, Structure, "");
		const FSpirvUniformity Uniformity = AnalyzeUniformity(Module, Structure);
		return !EmitKernel({Module, Structure, Uniformity, Reflection}, "test").empty();
	}
	catch (const FSpirvError&)
	{
		return false;
	}
}

} // namespace

TEST(SpirvReader, AcceptsWhatTheFrontEndWrites)
{
	EXPECT_TRUE(Walk(GetWords()));
}

TEST(SpirvReader, RefusesNothingAndNoise)
{
	EXPECT_FALSE(Walk({}));
	EXPECT_FALSE(Walk({Spirv::Magic}));
	EXPECT_FALSE(Walk(std::vector<uint32_t>(1000, 0xFFFFFFFF)));
	EXPECT_FALSE(Walk({Spirv::Magic, 0x10000, 0, 0xFFFFFFFF, 0}));
}

TEST(SpirvReader, RefusesFloatsInOperationsOfIntegers)
{
	constexpr size_t HeaderWords = 5;
	size_t NumChanged = 0;
	for (size_t At = HeaderWords; At < GetWords().size(); At += GetWords()[At] >> 16)
	{
		if ((GetWords()[At] & 0xffff) == Spirv::OpFMul)
		{
			std::vector<uint32_t> Words = GetWords();
			Words[At] = (Words[At] & 0xffff0000) | Spirv::OpIMul;
			std::string Error;
			try
			{
				ReadSpirv(Words);
			}
			catch (const FSpirvError& Refused)
			{
				Error = Refused.what();
			}
			EXPECT_NE(std::string::npos, Error.find("an operation of integers of what are floats")) << Error;
			++NumChanged;
		}
	}
	EXPECT_GT(NumChanged, 0u);
}

TEST(SpirvReader, SurvivesEveryTruncation)
{
	for (size_t Length = 0; Length < GetWords().size(); Length += 3)
	{
		EXPECT_FALSE(Walk(std::vector<uint32_t>(GetWords().begin(), GetWords().begin() + long(Length)))) << Length;
	}
}

TEST(SpirvReader, RefusesFewWordsThatStandForGigabytes)
{
	// float[65536], and constants of zeros of it, three words each.
	const auto ReadWith = [](uint32_t NumConstants) -> std::string
	{
		std::vector<uint32_t> Words = {0x07230203, 0x00010000, 0, 5 + NumConstants, 0, 3u << 16 | 22, 1, 32,
			4u << 16 | 21, 2, 32, 0, 4u << 16 | 43, 2, 3, 65536, 4u << 16 | 28, 4, 1, 3};
		for (uint32_t Index = 0; Index < NumConstants; ++Index)
		{
			Words.insert(Words.end(), {3u << 16 | 46, 4, 5 + Index});
		}
		try
		{
			ReadSpirv(Words);
			return "";
		}
		catch (const FSpirvError& Error)
		{
			return Error.what();
		}
	};
	const std::string TooMany = "the shader has more than 4194304 numbers in its constants";
	EXPECT_EQ(0u, ReadWith(64).find(TooMany)) << "the length of the array is a constant too";
	EXPECT_NE(0u, ReadWith(63).find(TooMany));
}

TEST(SpirvReader, SurvivesMutations)
{
	std::mt19937 Random(20240607);
	int Accepted = 0;
	for (int Round = 0; Round < 4000; ++Round)
	{
		std::vector<uint32_t> Words = GetWords();
		const int Changes = 1 + int(Random() % 3);
		for (int i = 0; i < Changes; ++i)
		{
			const size_t At = 5 + Random() % (Words.size() - 5);
			switch (Random() % 5)
			{
			case 0:
				Words[At] = Random();
				break;
			case 1:
				Words[At] ^= 1u << (Random() % 32);
				break;
			case 2:
				Words[At] = Random() % Words[3];
				break;
			case 3:
				Words[At] = Words[5 + Random() % (Words.size() - 5)];
				break;
			default:
				Words[At] += Random() % 3 - 1;
				break;
			}
		}
		Accepted += Walk(Words);
	}
	EXPECT_GT(Accepted, 0); // names and literals may change without harm
}
