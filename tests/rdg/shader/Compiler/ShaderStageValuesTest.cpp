// What goes between the stages and out of a pixel shader besides floats of TEXCOORDs: colours, integers, depth. By
// kernels of every width, with and without quads, by the interpreter and by the shader as it is looked into.
#include "ShaderDirectories.h"
#include "ShaderHarness.h"
#include "VertexProgram.h"

#include <gtest/gtest.h>

namespace Drydock::Test
{
namespace
{

constexpr int32_t GWidth = 21; // no multiple of a pack
constexpr int32_t GHeight = 3;

/** The targets' first texels of each run. Slots 16 and 17 hold COLOR0 and COLOR1, slot 2 integers, slots from 20 on
 * semantics of other names. */
template<typename F>
void RunAll(const std::string& Text, size_t NumTargets, F Check)
{
	const auto Run = [&](auto Call)
	{
		FShaderHarness Harness(Text, "Main", EShaderStage::Pixel);
		for (size_t i = 0; i < NumTargets; ++i)
		{
			Harness.Targets.emplace_back(GWidth, GHeight);
		}
		Harness.Interpolants[16] = {{0.25, 0, 0, 1}, {0.5, 0, 0, 0}, {0, 2, 0, 0}};
		Harness.Interpolants[17] = {{7, 8, 9, 10}, {}, {}};
		Harness.Interpolants[2] = {{4294967295.0, -2147483648.0, 16777217, 3}, {}, {}};
		for (int32_t i = GFirstNamedInterpolant; i < GMaxInterpolants; ++i)
		{
			Harness.Interpolants[i] = {{100.0 * i, 100.0 * i + 1, 2, 3}, {}, {}};
		}
		Call(Harness);
		Check(Harness);
	};
	for (const int32_t Lanes : GetLaneCounts())
	{
		Run([=](FShaderHarness& H) { H.Run(Lanes, GWidth, GHeight); });
	}
	Run([](FShaderHarness& H) { H.RunInspected(GWidth, GHeight); });
	Run([](FShaderHarness& H) { H.RunModel(GWidth, GHeight); });
}

TEST(ShaderStageValues, ColoursAreInterpolated)
{
	RunAll("float4 Main(float4 A : COLOR, float4 B : COLOR1) : SV_Target0 { return float4(A.xy, B.w, A.w); }\n", 1,
		[](FShaderHarness& H)
		{
			for (int32_t i = 0; i < GWidth * GHeight; ++i)
			{
				const float* const Texel = H.Targets[0].Texel(i % GWidth, i / GWidth);
				EXPECT_FLOAT_EQ(0.25f + 0.5f * (float(i % GWidth) + 0.5f), Texel[0]);
				EXPECT_FLOAT_EQ(2.0f * (float(i / GWidth) + 0.5f), Texel[1]);
				EXPECT_EQ(10, Texel[2]);
				EXPECT_EQ(1, Texel[3]);
			}
		});
}

TEST(ShaderStageValues, SemanticsOfAnyNameArrive)
{
	const std::string Text = "struct FIn { float4 P : SV_POSITION; float3 Unused : NORMAL; float2 A : Tangent1;\n"
							 "	float3x2 M : BASIS; float4 C : COLOR4; };\n"
							 "float4 Main(FIn In, float2 T : TEXCOORD20) : SV_Target0\n"
							 "{ return float4(In.A.y, In.M[1].x, In.C.x, T.y); }\n";
	RunAll(Text, 1,
		[](FShaderHarness& H)
		{
			const float* const Texel = H.Targets[0].Texel(3, 1);
			EXPECT_EQ(2101, Texel[0]);
			EXPECT_EQ(2300, Texel[1]);
			EXPECT_EQ(2500, Texel[2]);
			EXPECT_EQ(2601, Texel[3]);
		});
	FShaderHarness Harness(Text, "Main", EShaderStage::Pixel);
	EXPECT_EQ((std::vector<std::string>{"", "TANGENT1", "", "BASIS1", "", "COLOR4", "TEXCOORD20"}),
		ReflectShader(Harness.Request).NamedInterpolants);
}

/** One layer, one viewport and one sample: nothing chooses others. */
TEST(ShaderStageValues, LayersAndSamplesAreTheOnlyOnes)
{
	RunAll("float4 Main(uint L : SV_RenderTargetArrayIndex, uint V : SV_ViewportArrayIndex, uint S : SV_SampleIndex,\n"
		   "	uint C : SV_Coverage) : SV_Target0 { return float4(L + 5, V + 6, S + 7, C); }\n",
		1,
		[](FShaderHarness& H)
		{
			const float* const Texel = H.Targets[0].Texel(GWidth - 1, 1);
			EXPECT_EQ((std::vector<float>{5, 6, 7, 1}), std::vector<float>(Texel, Texel + 4));
		});
}

TEST(ShaderStageValues, FxcTakesTheOutputsOfDirect3D9)
{
	const std::string Text =
		"struct FOut { float4 A : COLOR1; float D : DEPTH; };\n"
		"float4 Main(float4 In : COLOR, out FOut Out) : COLOR { Out.A = 2; Out.D = 0.25; return In; }\n";
	FShaderHarness Harness(Text, "Main", EShaderStage::Pixel);
	Harness.Request.Defines = {{FxcRulesDefine, "1"}};
	Harness.Targets.resize(size_t(GDepthTarget) + 1, FTestTexture(1, 1));
	Harness.Interpolants[16].Base[1] = 0.75;
	Harness.Run(4, 1, 1);
	EXPECT_EQ(0.75f, Harness.Targets[0].Texel(0, 0)[1]);
	EXPECT_EQ(2, Harness.Targets[1].Texel(0, 0)[3]);
	EXPECT_EQ(0.25f, *Harness.Targets[GDepthTarget].Texel(0, 0));
	Harness.Request.GeneratedFiles[0].second = "float4 Main(out float4 A : SV_Target0) : COLOR { A = 1; return 1; }\n";
	EXPECT_THROW(ReflectShader(Harness.Request), FError);
}

/** A sampler of Direct3D 9 is a texture and a sampler of one name. */
TEST(ShaderStageValues, TextOfDirect3D9ReadsTexturesByItsSamplers)
{
	const size_t Keep = CountShaderDirectories();
	AddShaderDirectory("/Engine", DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/Engine");
	AddShaderDirectory("/Engine/Private", DRYDOCK_TEST_SOURCE_DIR "/passes/Shaders");
	AddShaderDirectory("/Drydock", DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/Drydock");
	FShaderHarness Harness("#define DRYDOCK_D3D9 1\n#include \"/Drydock/Private/UnityCG.ush\"\n"
						   "sampler s0 : register(s0);\nfloat4 p0 : register(c0);\n"
						   "float4 Main(float2 UV : TEXCOORD0) : COLOR { return tex2D(s0, UV) * p0[1]; }\n",
		"Main", EShaderStage::Pixel);
	Harness.Request.Defines = {{FxcRulesDefine, "1"}};
	const FShaderReflection Reflection = ReflectShader(Harness.Request);
	ForgetShaderDirectories(Keep);
	ASSERT_EQ(1u, Reflection.Textures.size());
	EXPECT_EQ("s0_Texture", Reflection.Textures[0].Name);
	ASSERT_EQ(1u, Reflection.Samplers.size());
	EXPECT_EQ("s0_Sampler", Reflection.Samplers[0].Name);
	EXPECT_EQ(1, Reflection.NumTargets);
}

TEST(ShaderStageValues, EveryBitOfAnIntegerArrives)
{
	const auto ExpectBits = [](FShaderHarness& H, std::array<uint32_t, 4> Expected)
	{
		for (int32_t i = 0; i < GWidth * GHeight; ++i)
		{
			std::array<uint32_t, 4> Words;
			std::memcpy(Words.data(), H.Targets[0].Texel(i % GWidth, i / GWidth), 16);
			EXPECT_EQ(Expected, Words);
		}
	};
	RunAll("uint4 Main(nointerpolation uint A : TEXCOORD2) : SV_Target0 { return uint4(A, A >> 31, 0, 1); }\n", 1,
		[&](FShaderHarness& H) {
			ExpectBits(H, {0xFFFFFFFFu, 1, 0, 1});
		});
	RunAll("struct FIn { nointerpolation int4 A : TEXCOORD2; };\n"
		   "int4 Main(FIn In) : SV_Target0 { return int4(In.A.y, In.A.z, In.A.w, In.A.y >> 31); }\n",
		1,
		[&](FShaderHarness& H) {
			ExpectBits(H, {0x80000000u, 16777217, 3, 0xFFFFFFFFu});
		});
}

TEST(ShaderStageValues, DepthIsWrittenWithinItsRange)
{
	RunAll("float4 Main(float4 P : SV_POSITION, out float D : SV_Depth) : SV_Target0\n"
		   "{ D = P.x > 5 ? 3 : P.y > 1 ? -1 : P.x / 8; return P; }\n",
		size_t(GDepthTarget) + 1,
		[](FShaderHarness& H)
		{
			for (int32_t i = 0; i < GWidth * GHeight; ++i)
			{
				const float X = float(i % GWidth) + 0.5f;
				const float* const Depth = H.Targets[GDepthTarget].Texel(i % GWidth, i / GWidth);
				EXPECT_EQ(X > 5 ? 1 : i >= GWidth ? 0 : X / 8, std::clamp(*Depth, 0.0f, 1.0f));
				EXPECT_EQ(X, H.Targets[0].Texel(i % GWidth, i / GWidth)[0]);
			}
		});
	FShaderHarness Harness("float4 Main(out float D : SV_DepthLessEqual) : SV_Target0 { D = 1; return 1; }\n", "Main",
		EShaderStage::Pixel);
	EXPECT_TRUE(ReflectShader(Harness.Request).bWritesDepth);
	EXPECT_EQ(1, ReflectShader(Harness.Request).NumTargets);
}

} // namespace
} // namespace Drydock::Test
