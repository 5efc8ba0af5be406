// The portability lint: one planted fault for each rule, with its line, and its neighbour that is none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderDirectories.h"
#include "EngineNames.h"
#include "ShaderLint.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace
{

using namespace Drydock;

FShaderCompileRequest MakeRequest(const std::string& Text, EShaderStage Stage = EShaderStage::Compute)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/Test/Shader.usf";
	Request.GeneratedFiles = {{Request.VirtualPath, Text}};
	Request.EntryPoint = "Main";
	Request.Stage = Stage;
	return Request;
}

/** "rule:line" of each finding. */
std::vector<std::string> Lint(const FShaderCompileRequest& Request, uint8_t Platforms = 0xFF)
{
	std::vector<std::string> Result;
	for (const FLintFinding& Finding : LintShader(Request, Platforms))
	{
		EXPECT_EQ("/Test/Shader.usf", Finding.File);
		Result.push_back(Finding.Rule->Id + std::string(":") + std::to_string(Finding.Line));
	}
	return Result;
}

std::string Repeat(int Count, const std::string& Text)
{
	std::string Result;
	for (int i = 0; i < Count; ++i)
	{
		std::string One = Text;
		for (size_t At = One.find('#'); At != std::string::npos; At = One.find('#', At))
		{
			One.replace(At, 1, std::to_string(i));
		}
		Result += One;
	}
	return Result;
}

std::string Compute(const std::string& Declarations, const std::string& Body, const std::string& Threads = "8, 8, 1")
{
	return Declarations + "\n[numthreads(" + Threads + ")]\nvoid Main(uint3 Id : SV_DispatchThreadID)\n{\n" + Body +
		   "\n}\n";
}

struct FPlanted
{
	std::string Rule;
	int Line;
	FShaderCompileRequest Faulty;
	FShaderCompileRequest Clean;
};

std::vector<FPlanted> GetPlanted()
{
	constexpr EShaderStage Pixel = EShaderStage::Pixel;
	const auto Declare = [](const std::string& Type, int Count)
	{
		return Repeat(Count, Type + " T#;");
	};
	const auto Targets = [](int Count)
	{
		return MakeRequest("void Main(float4 P : SV_POSITION" + Repeat(Count, ", out float4 C# : SV_Target#") + ")\n{" +
							   Repeat(Count, " C# = P;") + "\n}\n",
			Pixel);
	};
	const std::string Float4 = "RWTexture2D<float4> Out;";
	const std::string Uint = "RWStructuredBuffer<uint> Out;";
	return {
		{"atomics-texture", 5, MakeRequest(Compute("RWTexture2D<uint> Out;", "	InterlockedAdd(Out[Id.xy], 1);")),
			MakeRequest(Compute(Uint, "	InterlockedAdd(Out[Id.x], 1);"))},
		{"barrier-divergent", 6,
			MakeRequest(Compute(Uint + "groupshared uint G[64];",
				"	if (Id.x > 3)\n	GroupMemoryBarrierWithGroupSync(); G[Id.x] = 1; Out[Id.x] = G[0];")),
			MakeRequest(Compute(Uint + "groupshared uint G[64]; uint Use;",
				"	if (Use > 3)\n	GroupMemoryBarrierWithGroupSync(); G[Id.x] = 1; Out[Id.x] = G[0];"))},
		{"buffer-length", 5,
			MakeRequest(Compute(Uint, "	uint Count, Stride; Out.GetDimensions(Count, Stride); Out[0] = Count;")),
			MakeRequest(Compute(Uint + " uint Count;", "	Out[0] = Count;"))},
		{"constant-buffer-size", 0, MakeRequest(Compute(Uint + " float4 V[4097];", "	Out[Id.x] = uint(V[Id.x].x);")),
			MakeRequest(Compute(Uint + " float4 V[4096];", "	Out[Id.x] = uint(V[Id.x].x);"))},
		{"derivative-divergent", 4,
			MakeRequest("Texture2D T; SamplerState S;\nfloat4 Main(float4 P : SV_POSITION) : SV_Target0\n"
						"{ float4 C = 0; if (P.x > 8)\n	C = T.Sample(S, P.xy); return C; }\n",
				Pixel),
			MakeRequest("Texture2D T; SamplerState S; int Use;\nfloat4 Main(float4 P : SV_POSITION) : SV_Target0\n"
						"{ float4 C = 0; if (Use > 8)\n	C = T.Sample(S, P.xy); return C; }\n",
				Pixel)},
		{"compiler-warning", 5, MakeRequest(Compute("RWBuffer<float> Out;", "	float A = Id.xy; Out[Id.x] = A;")),
			MakeRequest(Compute("RWBuffer<float> Out;", "	float A = Id.x; Out[Id.x] = A;"))},
		{"float3-layout", 6,
			MakeRequest(Compute("struct E { float A; float3 B; };\nStructuredBuffer<E> In; RWBuffer<float> Out;",
				"	Out[Id.x] = In[Id.x].B.z;")),
			MakeRequest(Compute("struct E { float3 B; float A; };\nStructuredBuffer<E> In; RWBuffer<float> Out;",
				"	Out[Id.x] = In[Id.x].B.z;"))},
		{"groupshared-16k", 0,
			MakeRequest(Compute(Uint + "groupshared uint G[4089];", "	G[Id.x] = Id.y; Out[Id.x] = G[Id.x];")),
			MakeRequest(Compute(Uint + "groupshared uint G[4088];", "	G[Id.x] = Id.y; Out[Id.x] = G[Id.x];"))},
		{"hidden-counter", 5, MakeRequest(Compute("AppendStructuredBuffer<uint> Out;", "	Out.Append(Id.x);")),
			MakeRequest(Compute(Uint, "	Out[Id.x] = 1;"))},
		{"input-order", 2,
			MakeRequest("struct FIn { float4 P : SV_POSITION;\n	float2 UV : TEXCOORD0; };\n"
						"float4 Main(FIn In, uniform float A) : SV_Target0 { return In.UV.xyxy + A; }\n",
				Pixel),
			MakeRequest("float4 Main(float2 UV : TEXCOORD0, float4 P : SV_POSITION, bool B : SV_IsFrontFace) : "
						"SV_Target0 { return UV.xyxy + P + B; }\n",
				Pixel)},
		{"out-not-set", 2,
			MakeRequest("RWBuffer<float> Out; struct S { float A; float B; };\n"
						"void F(uint I, out S R) { R.A = 1; if (I > 3) { R.B = 2; } }\n[numthreads(1, 1, 1)] void "
						"Main(uint I : SV_DispatchThreadID) { S R; F(I, R); Out[I] = R.A + R.B; }\n"),
			MakeRequest("RWBuffer<float> Out; struct S { float A; float B; };\n"
						"void F(uint I, out S R) { R.A = 1; if (I > 3) { R.B = 2; return; } R.B = 0; }\n"
						"[numthreads(1, 1, 1)] void Main(uint I : SV_DispatchThreadID) { S R; F(I, R); Out[I] = R.A + "
						"R.B; }\n")},
		{"double", 0, MakeRequest(Compute("RWStructuredBuffer<double> Out;", "	Out[Id.x] = Id.x * 0.1L;")),
			MakeRequest(Compute("RWStructuredBuffer<float> Out;", "	Out[Id.x] = Id.x * 0.1;"))},
		{"not-in-engine", 1,
			MakeRequest("#include \"/Drydock/Private/ScreenMapping.ush\"\n" +
						Compute(Float4, "	Out[Id.xy] = MapPixelToInputUV(Id.xy, 0, 1, 0, 1).xyxy;")),
			MakeRequest("#include \"/Engine/Private/MortonCode.ush\"\n" +
						Compute(Float4, "	Out[Id.xy] = MortonEncode(Id.xy);"))},
		{"partial-uav-store", 5, MakeRequest(Compute(Float4, "	Out[Id.xy].rgb = 1;")),
			MakeRequest(Compute(Float4 + "void F(uint2 P) { Out[P].x = 1; }", "	Out[Id.xy] = 1;"))},
		{"render-targets", 0, Targets(5), Targets(4)},
		{"sampler-count", 0,
			MakeRequest(Compute(Declare("SamplerState", 17) + "Texture2D P; RWBuffer<float> Out;",
				Repeat(17, "	Out[#] = P.SampleLevel(T#, 0.5, 0).x;"))),
			MakeRequest(Compute(Declare("SamplerState", 16) + "Texture2D P; RWBuffer<float> Out;",
				Repeat(16, "	Out[#] = P.SampleLevel(T#, 0.5, 0).x;")))},
		{"structure-stride", 5,
			MakeRequest(Compute("struct E { float4 V[129]; }; StructuredBuffer<E> In; RWBuffer<float> Out;",
				"	Out[Id.x] = In[Id.x].V[Id.y].z;")),
			MakeRequest(Compute("struct E { float4 V[128]; }; StructuredBuffer<E> In; RWBuffer<float> Out;",
				"	Out[Id.x] = In[Id.x].V[Id.y].z;"))},
		{"texture-count", 0,
			MakeRequest(Compute(Declare("Texture2D", 31) + "RWTexture2D<float> Out;",
				"	float V = 0;" + Repeat(31, "V += T#[Id.xy].x;") + "	Out[Id.xy] = V;")),
			MakeRequest(Compute(Declare("Texture2D", 30) + "RWTexture2D<float> Out;",
				"	float V = 0;" + Repeat(30, "V += T#[Id.xy].x;") + "	Out[Id.xy] = V;"))},
		{"texture-levels", 5,
			MakeRequest(Compute("Texture2D T;" + Uint, "	uint W, H, N; T.GetDimensions(0, W, H, N); Out[0] = N;")),
			MakeRequest(Compute("Texture2D T;" + Uint, "	uint W, H; T.GetDimensions(W, H); Out[0] = W;"))},
		{"texture-read-write", 5, MakeRequest(Compute(Float4, "	Out[Id.xy] = Out[Id.xy] * 2;")),
			MakeRequest(Compute(Float4 + "RWTexture2D<float4> In;", "	Out[Id.xy] = In[Id.xy] * 2;"))},
		{"threads-512", 0, MakeRequest(Compute(Uint, "	Out[Id.x] = 1;", "32, 32, 1")),
			MakeRequest(Compute(Uint, "	Out[Id.x] = 1;", "32, 16, 1"))},
		{"typed-uav-load", 5, MakeRequest(Compute(Float4, "	Out[Id.xy] = Out[Id.xy] * 2;")),
			MakeRequest(Compute("RWTexture2D<float> Out;", "	Out[Id.xy] = Out[Id.xy] * 2;"))},
		{"typed-uav-load-optional", 5, MakeRequest(Compute(Float4, "	Out[Id.xy] = Out[Id.xy] * 2;")),
			MakeRequest(Compute("RWTexture2D<int> Out;", "	Out[Id.xy] = Out[Id.xy] * 2;"))},
		{"types-16", 5, MakeRequest(Compute("RWStructuredBuffer<float16_t> Out;", "	Out[Id.x] = float16_t(Id.x);")),
			MakeRequest(Compute("RWStructuredBuffer<min16float> Out;", "	Out[Id.x] = min16float(Id.x);"))},
		{"uav-count", 0, MakeRequest(Compute(Declare("RWBuffer<float>", 9), Repeat(9, "	T#[Id.x] = 1;"))),
			MakeRequest(Compute(Declare("RWBuffer<float>", 8), Repeat(8, "	T#[Id.x] = 1;")))},
		{"uav-size", 5,
			MakeRequest(Compute(Float4, "	uint2 Size; Out.GetDimensions(Size.x, Size.y); Out[Id.xy] = Size.x;")),
			MakeRequest(Compute(
				Float4 + "Texture2D In;", "	uint2 Size; In.GetDimensions(Size.x, Size.y); Out[Id.xy] = Size.x;"))},
		{"wave-operations", 5, MakeRequest(Compute(Uint, "	Out[Id.x] = WaveActiveSum(Id.x);")),
			MakeRequest(Compute(Uint, "	Out[Id.x] = Id.x;"))},
	};
}

/** A module with nothing but a capability. */
std::vector<std::string> LintCapability(uint32_t Capability)
{
	const std::vector<uint32_t> Words = {0x07230203, 0x10000, 0, 1, 0, (2u << 16) | 17, Capability};
	std::vector<std::string> Result;
	const FShaderCompileRequest Request = MakeRequest("");
	std::vector<FDiagnostic> Refused;
	for (const FLintFinding& Finding : LintSpirv(Words, "", Request, 0xFF, &Refused))
	{
		Result.push_back(Finding.Rule->Id);
	}
	EXPECT_EQ(1u, Refused.size()) << "what is not looked at is told";
	return Result;
}

} // namespace

TEST(ShaderLint, NamesThatTheEnginesVersionDoesNotHave)
{
	AddShaderDirectory("/Engine", DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/Engine");
	const FShaderCompileRequest Request = MakeRequest(
		"#include \"/Engine/Private/Common.ush\"\n" +
		Compute("RWTexture2D<float4> Out;", "	// FDFScalar in a comment\n	FDFScalar V = 1; Out[Id.xy] = V;"));
	for (const int Minor : {0, 3, 4})
	{
		SetLintEngine(Minor);
		EXPECT_EQ(Minor == 3 ? std::vector<std::string>{"not-in-engine:7"} : std::vector<std::string>(), Lint(Request));
	}
	SetLintEngine(0);
}

TEST(ShaderLint, EachRuleFindsItsPlantedFaultInItsLine)
{
	AddShaderDirectory("/Engine", DRYDOCK_TEST_SOURCE_DIR "/rdg/graph/Shaders/Engine");
	AddShaderDirectory("/Drydock/Private", DRYDOCK_TEST_SOURCE_DIR "/passes/Shaders/Drydock");
	for (const FPlanted& Planted : GetPlanted())
	{
		const std::vector<std::string> Found = Lint(Planted.Faulty);
		const auto OfRule = [&Planted](const std::string& Each)
		{
			return Each.starts_with(Planted.Rule + ":");
		};
		const auto First = std::find_if(Found.begin(), Found.end(), OfRule);
		ASSERT_NE(Found.end(), First) << Planted.Rule << ": " << testing::PrintToString(Found);
		EXPECT_TRUE(Planted.Line == 0 || *First == Planted.Rule + ":" + std::to_string(Planted.Line)) << *First;
		const std::vector<std::string> Clean = Lint(Planted.Clean);
		EXPECT_TRUE(std::none_of(Clean.begin(), Clean.end(), OfRule))
			<< Planted.Rule << ": " << testing::PrintToString(Clean);
	}
}

TEST(ShaderLint, Capabilities)
{
	EXPECT_EQ(std::vector<std::string>({"types-16"}), LintCapability(9));
	EXPECT_EQ(std::vector<std::string>({"double"}), LintCapability(10));
	EXPECT_EQ(std::vector<std::string>({"types-16"}), LintCapability(22));
	EXPECT_EQ(std::vector<std::string>({"int64"}), LintCapability(11));
	EXPECT_EQ(std::vector<std::string>({"atomics-64"}), LintCapability(12));
	EXPECT_EQ(std::vector<std::string>(), LintCapability(1));
}

TEST(ShaderLint, EveryRuleIsPlanted)
{
	std::set<std::string> Planted = {"int64", "atomics-64"}; // by their capabilities
	for (const FPlanted& Each : GetPlanted())
	{
		Planted.insert(Each.Rule);
	}
	std::set<std::string> Rules;
	for (const FLintRule& Rule : GetLintRules())
	{
		EXPECT_TRUE(Rules.empty() || *Rules.rbegin() < Rule.Id) << Rule.Id << " is not in the order of the ids";
		EXPECT_TRUE(std::string(Rule.Source).starts_with("https://")) << Rule.Id;
		EXPECT_NE(0, Rule.Platforms) << Rule.Id;
		Rules.insert(Rule.Id);
	}
	EXPECT_EQ(Rules, Planted);
}

TEST(ShaderLint, OnlyWhatMattersOnThePlatform)
{
	const FShaderCompileRequest Request =
		MakeRequest(Compute("RWStructuredBuffer<uint> Out;", "	Out[Id.x] = WaveActiveSum(Id.x);"));
	EXPECT_EQ(std::vector<std::string>({"wave-operations:5"}), Lint(Request, LintD3D11));
	EXPECT_EQ(std::vector<std::string>(), Lint(Request, LintSM6 | LintVulkan | LintMetal | LintMobile));
}

TEST(ShaderLint, APartialStoreIsNoReadOfTheAuthors)
{
	const FShaderCompileRequest Request = MakeRequest(Compute("RWTexture2D<float4> Out;", "	Out[Id.xy].x = 1;"));
	EXPECT_EQ(std::vector<std::string>({"partial-uav-store:5"}), Lint(Request));
}

TEST(ShaderLint, OfResourcesInStructsTheLineIsThatOfTheirUse)
{
	const FShaderCompileRequest Request = MakeRequest(R"(struct FBuffers
{
	RWTexture2D<float4> B;
};
FBuffers Buffers;
[numthreads(8, 8, 1)]
void Main(uint2 Id : SV_DispatchThreadID)
{
	Buffers.B[Id].rg = 1;

	Buffers.B[Id + 8] = Buffers.B[Id] * 2;

}
)");
	EXPECT_EQ(std::vector<std::string>({"partial-uav-store:9", "typed-uav-load:11"}), Lint(Request, LintD3D11));
}

/** Ways to a barrier that some threads of a group do not take, and ways that all take. */
TEST(ShaderLint, BarriersThatThreadsMayMissHaveBothLines)
{
	const auto Barriers = [](const std::string& Body)
	{
		std::vector<std::string> Result;
		for (const FLintFinding& Finding :
			LintShader(MakeRequest(Compute("RWStructuredBuffer<uint> Out; groupshared uint G; int Use;", Body)), 0xFF))
		{
			if (Finding.Rule->Id == std::string("barrier-divergent"))
			{
				Result.push_back(std::to_string(Finding.Line) + ": " + Finding.What);
			}
		}
		return Result;
	};
	const std::string Sync = "GroupMemoryBarrierWithGroupSync();\n";
	const std::string End = "Out[Id.x] = G;";
	using FLines = std::vector<std::string>;
	EXPECT_EQ(FLines({"6: threads part in line 5"}), Barriers("if (Id.x < 3)\n" + Sync + End));
	EXPECT_EQ(FLines({"7: threads part in line 5"}), Barriers("if (Id.x < 3)\nG = 1; else\n" + Sync + End));
	EXPECT_EQ(FLines({"8: threads part in line 5"}), Barriers("if (Id.x < 3)\nreturn;\nG = 1;\n" + Sync + End));
	EXPECT_EQ(FLines({"7: threads part in line 5"}),
		Barriers("if (Id.x < 3) { if (Use > 1)\nreturn; }\n" + Sync + End)); // within what parts
	EXPECT_EQ(FLines({"7: threads part in line 6"}),
		Barriers("for (int i = 0; i < Use; ++i) {\nif (Id.x < i) continue;\n" + Sync + "}\n" + End));
	EXPECT_EQ(FLines({"6: threads part in line 7"}),
		Barriers("for (int i = 0; i < Use; ++i) {\n" + Sync + "if (Id.x < i) return;\n}\n" + End));
	EXPECT_EQ(1u, Barriers("for (int i = 0; i < int(Id.x); ++i) {\n" + Sync + "}\n" + End).size());
	EXPECT_EQ(FLines({"7: threads part in line 6"}), Barriers("G = Id.x;\nif (G > 3)\n" + Sync + End));
	EXPECT_EQ(FLines(), Barriers("G = Id.x;" + Sync + "if (G > 3) {\n" + Sync + "}\n" + End));
	EXPECT_EQ(FLines(), Barriers("G = Id.x;" + Sync + "if (G > 3) return;\n" + Sync + End));
	EXPECT_EQ(FLines(), Barriers("if (Use < 3)\nreturn;\n" + Sync + End));
	EXPECT_EQ(FLines(), Barriers("if (Id.x < 3)\nG = 2;\n" + Sync + End));
	EXPECT_EQ(FLines(), Barriers("for (int i = 0; i < Use; ++i) {\n" + Sync + "if (Id.x < i) G = i;\n}\n" + End));
	EXPECT_EQ(FLines(), Barriers("for (int i = 0; i < int(Id.x); ++i)\nG = i;\n" + Sync + End));
}

TEST(ShaderLint, AShaderMayAllowWhatItMeans)
{
	const std::string Float4 = "RWTexture2D<float4> Out;";
	const auto LintText = [](const std::string& Text)
	{
		return Lint(MakeRequest(Text), LintD3D11 | LintMobile);
	};
	const std::string Comment = "	// drydock-lint: allow partial-uav-store: one thread for each texel\n";
	EXPECT_EQ(std::vector<std::string>(), LintText(Compute(Float4, Comment + "	Out[Id.xy].x = 1;")));
	EXPECT_EQ(std::vector<std::string>(), LintText(Compute(Float4, "	Out[Id.xy].x = 1;" + Comment)));
	EXPECT_EQ(std::vector<std::string>({"partial-uav-store:7"}),
		LintText(Compute(Float4, Comment + "	uint2 P = Id.xy;\n	Out[P].x = 1;")))
		<< "of another line";
	const auto LintGroup = [&](const std::string& Behind)
	{
		return LintText(Compute(Float4, "	Out[Id.xy] = 1;" + Behind, "32, 32, 1"));
	};
	EXPECT_EQ(std::vector<std::string>({"threads-512:0"}), LintGroup(""));
	EXPECT_EQ(std::vector<std::string>(), LintGroup(" // drydock-lint: allow threads-512: big"));
	EXPECT_EQ(std::vector<std::string>({"threads-512:0"}), LintGroup(" // drydock-lint: allow threads: big"));
}

/** Else the time of a file would be the square of its entry points. */
TEST(ShaderLint, EachEntryOfAFileIsReadWithoutTheOthers)
{
	std::string Text = "RWTexture2D<float4> Out;\nTexture2D T;\nSamplerState S;\nfloat H(float x) { return 2 * x; }\n"
					   "[numthreads(8, 8, 1)]\nvoid CalledCS(uint2 P : SV_DispatchThreadID) { Out[P].x = H(1); }\n";
	for (const char* const Number : {"1", "2", "3"})
	{
		Text += std::string("[numthreads(32, 32, 1)]\nvoid Part") + Number +
				"CS(uint2 P : SV_DispatchThreadID)\n{\n	CalledCS(P);\n	Out[P].y = T.SampleLevel(S, 0, 0).x;\n}\n" +
				"float4 Shown" + Number + "PS(float4 P : SV_POSITION) : SV_Target0\n{\n#if PIXELSHADER\n" +
				"	return ddx(P.x) * H(P.y);\n#endif\n	return 0;\n}\n";
	}
	FShaderCompileRequest Request = MakeRequest(Text);
	const std::vector<FShaderEntry> Entries = FindShaderEntries(Request);
	ASSERT_EQ(7u, Entries.size());
	FFileLinter Linter;
	for (const FShaderEntry& Entry : Entries)
	{
		Request.EntryPoint = Entry.Name;
		Request.Stage = Entry.Stage;
		const std::vector<FLintFinding> Whole = LintShader(Request, 0xFF);
		EXPECT_EQ(Whole, Linter.Lint(Request, 0xFF)) << Entry.Name;
		EXPECT_EQ(Entry.Stage == EShaderStage::Pixel, Whole.empty()) << Entry.Name;
		const std::string Own = FEntryTexts(Request).GetText(Entry.Name);
		if (Entry.Name == "CalledCS") // which others need
		{
			EXPECT_EQ("", Own);
			continue;
		}
		for (const FShaderEntry& Other : Entries)
		{
			EXPECT_EQ(&Entry == &Other || Other.Name == "CalledCS", Own.find(Other.Name) != std::string::npos)
				<< Entry.Name << " and " << Other.Name;
		}
	}
	Request = MakeRequest(Text + "[numthreads(8, 8, 1)] void FirstCS() { Missing = 1; }\n"
								 "[numthreads(8, 8, 1)] void SecondCS() { Lacking = 1; }\n");
	Request.EntryPoint = "FirstCS";
	Request.Stage = EShaderStage::Compute;
	EXPECT_THROW(Linter.Lint(Request, 0xFF), FError);
}

TEST(ShaderLint, EntriesAreFoundInTheText)
{
	const std::vector<FShaderEntry> Entries = FindShaderEntries(
		MakeRequest("float4 Helper() { return 1; }\n[numthreads(8, 8, 1)]\nvoid FirstCS(uint3 Id : SV_DispatchThreadID)"
					"\n{\n}\nfloat4 SecondPS(float4 P : SV_POSITION) : SV_Target0 { return Helper(); }\n"
					"void ThirdPS(out float4 C : SV_TARGET1) { C = 0; }\n"));
	ASSERT_EQ(3u, Entries.size());
	EXPECT_EQ("FirstCS", Entries[0].Name);
	EXPECT_EQ(EShaderStage::Compute, Entries[0].Stage);
	EXPECT_EQ("SecondPS", Entries[1].Name);
	EXPECT_EQ(EShaderStage::Pixel, Entries[1].Stage);
	EXPECT_EQ("ThirdPS", Entries[2].Name);
}

TEST(ShaderLint, APixelShaderWithoutTargetsIsAnEntry)
{
	const FShaderCompileRequest Request =
		MakeRequest("struct FIn { float2 UV : TEXCOORD0; float4 P : SV_POSITION; };\n"
					"void DiscardPS(FIn In) { if (In.UV.x < 0.5) discard; }\n"
					"void PlacePS(float4 P : SV_Position) { clip(P.x - 1); }\n"
					"void PlaceVS(uint Id : SV_VertexID, out float4 P : SV_POSITION) { P = Id; }\n"
					"void Called(FIn In) {}\nfloat4 MainPS(FIn In) : SV_Target0 { Called(In); return 1; }\n");
	std::vector<std::string> Names;
	for (const FShaderEntry& Entry : FindShaderEntries(Request))
	{
		Names.push_back(Entry.Name);
		EXPECT_EQ(EShaderStage::Pixel, Entry.Stage);
		FShaderCompileRequest Own = Request;
		Own.EntryPoint = Entry.Name;
		Own.Stage = Entry.Stage;
		EXPECT_TRUE(LintShader(Own, 0xFF).empty()) << Entry.Name;
	}
	EXPECT_EQ((std::vector<std::string>{"DiscardPS", "PlacePS", "MainPS"}), Names);
}

/** docs/lint.md is made of the table: DRYDOCK_BLESS=1 writes it anew. */
TEST(ShaderLint, DocIsMadeOfTheTable)
{
	std::string Page = R"(# The portability lint

`drydock lint SHADER...` reports shader code that will not compile or run on other platforms: Direct3D 11, shader model 6,
Vulkan, Metal or phones. It analyses the SPIR-V that drydock runs. It also reads the text where the front end lost
something.

```sh
drydock lint /MyPlugin/Private/Tint.usf --platform d3d11    # every permutation of the classes that name the file
drydock lint MyPlugin/Shaders/Private/Tint.usf --entry MainCS
drydock lint configs/toon_bloom.json --json                 # the shaders of a frame, and every shader class of its plugins
drydock lint --list                                         # the rules
```

A finding is printed as `FILE:LINE: error: WHAT: SENTENCE: WAY ROUND (PLATFORMS) [RULE]`. The exit code is 1 if an error was
found. An *error* will not compile or run on that platform. A *warning* fails on some of its devices, or may behave
differently there. `lint` does not report drydock's own limits; `check` does. A finding shared by several permutations is
reported once. If no shader class names a file, `lint` checks the file's entry points: functions with `[numthreads]`, and
functions that write `SV_Target`.

`lint` checks the plugins of a config as `check` does. It checks each global shader class that they register, whether or not
a pass of the frame uses it. It checks every permutation that `ShouldCompilePermutation` allows under the config's console
variables. A pass that `AddPass` makes of a lambda does not name its shader before it runs, but the shader's class is among
those checked. If a class has more than 256 permutations, `lint` checks 256 of them, spread over all dimensions. A note
(DD6013) names the class and counts the rest. The note also names a pass of a lambda whose plugin registers no shader class.
A broken class ends `lint` and `check` with exit code 2, even if the frame does not use it. `lint` still prints its findings
in the other shaders.

To suppress a finding that is intended, put a comment on its line or the line above. For a finding without a line, put the
comment anywhere in the file. `drydock lint` finds nothing else in the shaders that drydock ships.

```hlsl
// drydock-lint: allow threads-512: the article's blur has groups of 32 x 32 threads
```

`not-in-engine` reports what drydock has and the engine does not have: an include below `/Drydock`, an include of a file that
an article adds, and a function, structure or constant of drydock's own. The finding names the file that defines it and, if
known, the name that the engine has instead. `rdg/graph/Shaders/EngineNames.txt` lists the engine's names and states how
certain each is, and which versions have it. `--engine-minor X` also reports the names that engine 5.X does not have; the
finding says if that is uncertain. The rule does not look at C++: `drydock build --engine-minor X` does.

The table is made from `rdg/shader/Lint/LintRules.txt`. To write the page anew, run
`DRYDOCK_BLESS=1 build/release/bin/test_rdg_Compiler --gtest_filter='ShaderLint.Doc*'`. Each rule is stated by the
document that its name links to.

| rule | | platforms | what | way round |
|---|---|---|---|---|
)";
	for (const FLintRule& Rule : GetLintRules())
	{
		Page += std::string("| [`") + Rule.Id + "`](" + Rule.Source + ") | " +
				(Rule.Severity == ESeverity::Error ? "error" : "warning") + " | " +
				DescribeLintPlatforms(Rule.Platforms) + " | " + Rule.Sentence + " | " + Rule.WayRound + " |\n";
	}
	const std::string File = DRYDOCK_TEST_SOURCE_DIR "/docs/lint.md";
	if (std::getenv("DRYDOCK_BLESS"))
	{
		std::ofstream(File) << Page;
	}
	std::ostringstream Text;
	Text << std::ifstream(File).rdbuf();
	EXPECT_EQ(Page, Text.str());
}
