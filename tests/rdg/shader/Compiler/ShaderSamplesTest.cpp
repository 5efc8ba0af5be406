// Every form of sampling that HLSL has, in one shader: each thread's answers against a computation in double, and
// compiled kernels of every width, the interpreter and the shader as it is looked into against each other, bit for bit.
#include "../Lanes/LanesSampleOracle.h"
#include "ShaderHarness.h"

#include "LanesLod.h"

#include <limits>

namespace Drydock::Test
{
namespace
{

using Tests::FSampleCase;
using Tests::FTexel;
using FMips = Tests::FTestTexture;

constexpr int GThreads = 64;

const char* const GDeclarations =
	"Texture2D T; Texture2DArray TA; Texture3D V; TextureCube C; TextureCubeArray CA; Texture2D<float> D;\n"
	"Texture2DArray<float> DA; TextureCube<float> DC; TextureCubeArray<float> DCA; SamplerState S;\n"
	"SamplerComparisonState SC; StructuredBuffer<float4> In; StructuredBuffer<int4> Moves; "
	"RWStructuredBuffer<float4> Out;\n";

/** What an expression of A (coordinates), B and G (gradients; B.w: level or reference) and O (offsets) is in double. */
struct FForm
{
	const char* Text;
	const char* Texture;
	enum
	{
		Level,
		Grad,
		Compare,
		GatherCompare,
		Red,
		Green,
		Blue,
		Alpha,
		Size
	} Kind;
	int Offsets[4][2]; // OffsetX and OffsetY: those of the thread
};
constexpr int OffsetX = 100; // + 1, 2, 3: y, z, w
constexpr FForm GForms[] = {
	{"C.SampleLevel(S, A.xyz, B.w)", "C", FForm::Level, {}},
	{"CA.SampleLevel(S, A, B.w)", "CA", FForm::Level, {}},
	{"T.SampleLevel(S, A.xy, B.w, int2(-3, 1))", "T", FForm::Level, {{-3, 1}}},
	{"TA.SampleLevel(S, A.xyz, B.w, int2(2, 0))", "TA", FForm::Level, {{2, 0}}},
	{"T.SampleGrad(S, A.xy, B.xy, G.xy)", "T", FForm::Grad, {}},
	{"T.SampleGrad(S, A.xy, B.xy, G.xy, int2(2, -1))", "T", FForm::Grad, {{2, -1}}},
	{"TA.SampleGrad(S, A.xyz, B.xy, G.xy)", "TA", FForm::Grad, {}},
	{"C.SampleGrad(S, A.xyz, B.xyz, G.xyz)", "C", FForm::Grad, {}},
	{"CA.SampleGrad(S, A, B.xyz, G.xyz)", "CA", FForm::Grad, {}},
	{"D.SampleCmpLevelZero(SC, A.xy, B.w)", "D", FForm::Compare, {}},
	{"D.SampleCmpLevelZero(SC, A.xy, B.w, int2(1, 2))", "D", FForm::Compare, {{1, 2}}},
	{"DA.SampleCmpLevelZero(SC, A.xyz, B.w)", "DA", FForm::Compare, {}},
	{"DC.SampleCmpLevelZero(SC, A.xyz, B.w)", "DC", FForm::Compare, {}},
	{"DCA.SampleCmpLevelZero(SC, A, B.w)", "DCA", FForm::Compare, {}},
	{"D.GatherCmp(SC, A.xy, B.w)", "D", FForm::GatherCompare, {}},
	{"D.GatherCmp(SC, A.xy, B.w, int2(1, 1))", "D", FForm::GatherCompare, {{1, 1}, {1, 1}, {1, 1}, {1, 1}}},
	{"DA.GatherCmpRed(SC, A.xyz, B.w)", "DA", FForm::GatherCompare, {}},
	{"DC.GatherCmp(SC, A.xyz, B.w)", "DC", FForm::GatherCompare, {}},
	{"T.Gather(S, A.xy)", "T", FForm::Red, {}},
	{"T.GatherGreen(S, A.xy, int2(-2, 3))", "T", FForm::Green, {{-2, 3}, {-2, 3}, {-2, 3}, {-2, 3}}},
	{"T.GatherBlue(S, A.xy, O.xy)", "T", FForm::Blue,
		{{OffsetX, OffsetX + 1}, {OffsetX, OffsetX + 1}, {OffsetX, OffsetX + 1}, {OffsetX, OffsetX + 1}}},
	{"TA.GatherAlpha(S, A.xyz, int2(1, 0))", "TA", FForm::Alpha, {{1, 0}, {1, 0}, {1, 0}, {1, 0}}},
	{"T.GatherAlpha(S, A.xy, int2(0, 0), int2(3, 2), int2(-1, -4), int2(7, 1))", "T", FForm::Alpha,
		{{0, 0}, {3, 2}, {-1, -4}, {7, 1}}},
	{"T.GatherRed(S, A.xy, O.xy, O.zw, O.yx, O.wz)", "T", FForm::Red,
		{{OffsetX, OffsetX + 1}, {OffsetX + 2, OffsetX + 3}, {OffsetX + 1, OffsetX}, {OffsetX + 3, OffsetX + 2}}},
	{"C.GatherBlue(S, A.xyz)", "C", FForm::Blue, {}},
	{"CA.GatherGreen(S, A)", "CA", FForm::Green, {}},
};

/** bWaves: its threads tell each other something, so that lanes are as many as a wave has. */
std::string MakeShader(bool bWaves)
{
	std::string Text = GDeclarations;
	Text += "[numthreads(64, 1, 1)]\nvoid MainCS(uint3 Id : SV_DispatchThreadID)\n{\n"
			"\tfloat4 A = In[Id.x * 3], B = In[Id.x * 3 + 1], G = In[Id.x * 3 + 2];\n\tint4 O = Moves[Id.x];\n";
	if (bWaves)
	{
		Text += "\tA.x += WaveActiveMax(0.0f);\n";
	}
	int Form = 0;
	for (const FForm& Each : GForms)
	{
		Text += "\tOut[" + std::to_string(Form++ * GThreads) + " + Id.x] = " + Each.Text + ";\n";
	}
	for (const char* const Each : {"V.SampleGrad(S, A.xyz, B.xyz, G.xyz)", "T.SampleLevel(S, A.xy, 0, int2(1, -1))"})
	{
		Text += "\tOut[" + std::to_string(Form++ * GThreads) + " + Id.x] = " + Each + ";\n";
	}
	return Text + "}\n";
}
constexpr size_t GNumForms = std::size(GForms) + 2; // two of them without a computation of their own

struct FSamples
{
	FMips T{ETexelStorage::RGBA32_FLOAT, 16, 8, 1, 3};
	FMips TA{ETexelStorage::RGBA16_FLOAT, 8, 8, 3, 3};
	FMips V{ETexelStorage::RGBA32_FLOAT, 8, 4, 4, 2, true};
	FMips C{ETexelStorage::RGBA32_FLOAT, 8, 8, 6, 3};
	FMips CA{ETexelStorage::RGBA32_FLOAT, 4, 4, 18, 2};
	FMips D{ETexelStorage::R32_FLOAT, 5, 7};
	FMips DA{ETexelStorage::R16_UNORM, 4, 4, 3};
	FMips DC{ETexelStorage::R32_FLOAT, 4, 4, 6};
	FMips DCA{ETexelStorage::R32_FLOAT, 2, 2, 12};
	FShaderHarness Harness;
	std::vector<float> In = std::vector<float>(GThreads * 12);
	std::vector<int32_t> Moves = std::vector<int32_t>(GThreads * 4);

	explicit FSamples(uint32_t Seed, bool bWaves = false)
		: Harness(MakeShader(bWaves), "MainCS", EShaderStage::Compute)
	{
		Tests::FSampleRandom Random(Seed);
		for (auto& [Name, Texture] : GetTextures())
		{
			Texture->FillRandom(Seed++, 0, 1);
			Harness.Views[Name] = Texture->Texture;
		}
		for (float& Value : In)
		{
			Value = float(Random.Real(-1, 2));
		}
		for (size_t Thread = 0; Thread < GThreads; ++Thread)
		{
			In[Thread * 12 + 7] = float(Random.Real(-0.5, 3)); // level or reference
			for (size_t i = 4; i < 12; ++i)
			{
				In[Thread * 12 + i] *= i == 7 ? 1 : 0.3f;
			}
			if (Thread % 4 == 0)
			{
				In[Thread * 12 + 2] = float(Random.Int(-1, 3)) + 0.5f; // between two layers, or two cubes
				In[Thread * 12 + 3] = float(Random.Int(-1, 3)) + 0.5f;
			}
			for (size_t i = 0; i < 4; ++i)
			{
				Moves[Thread * 4 + i] = Random.Int(-8, 7);
			}
		}
		Harness.Sampler = {EKernelFilter::Trilinear, EKernelAddress::Wrap, EKernelAddress::Mirror,
			EKernelAddress::Border, 8, 0, {0.25f, 0, 0, 1}, EKernelCompare::Less};
	}

	std::map<std::string, FMips*> GetTextures()
	{
		return {{"T", &T}, {"TA", &TA}, {"V", &V}, {"C", &C}, {"CA", &CA}, {"D", &D}, {"DA", &DA}, {"DC", &DC},
			{"DCA", &DCA}};
	}

	void Fill()
	{
		Harness.SetFloatBuffer("In", In);
		Harness.Buffers["Moves"].assign(Moves.begin(), Moves.end());
		Harness.Buffers["Out"].assign(GNumForms * GThreads * 4, 0x7FC12345);
	}

	/** The sample of a thread in double; nothing where rounding decides. */
	std::optional<FTexel> Compute(const FForm& Form, size_t Thread)
	{
		const float* const Values = &In[Thread * 12];
		const std::string Name = Form.Texture;
		FSampleCase Case;
		Case.Texture = GetTextures().at(Name);
		Case.Sampler = Harness.Sampler;
		Case.bCube = Name.find('C') != std::string::npos;
		Case.bArray = Name.find('A') != std::string::npos;
		Case.bCompares = Form.Kind == FForm::Compare || Form.Kind == FForm::GatherCompare;
		Case.Reference = Values[7];
		if (Name == "DA")
		{
			Case.Reference = std::clamp(Case.Reference, 0.0, 1.0);
		}
		std::copy_n(Values, 4, Case.At);
		const auto Move = [&](const int(&Offset)[2])
		{
			for (int i = 0; i < 2; ++i)
			{
				Case.Offset[i] = Offset[i] >= OffsetX ? Moves[Thread * 4 + size_t(Offset[i] - OffsetX)] : Offset[i];
			}
		};
		if (Form.Kind <= FForm::Compare)
		{
			Move(Form.Offsets[0]);
			return SampleAt(Case, Form.Kind == FForm::Grad    ? GetLevel(Case, Values)
								  : Form.Kind == FForm::Level ? Values[7]
															  : 0);
		}
		constexpr size_t Order[4] = {2, 3, 1, 0};
		FTexel Result;
		for (size_t i = 0; i < 4; ++i)
		{
			Move(Form.Offsets[i]);
			const std::optional<FSampleCase::FFour> Four = Case.FindFour(0, false);
			if (!Four)
			{
				return {};
			}
			const int Component = Form.Kind >= FForm::Red ? Form.Kind - FForm::Red : 0;
			Result[i] = Four->Texels[Order[i]][size_t(Component)];
		}
		return Result;
	}

private:
	static double GetLevel(const FSampleCase& Case, const float* Values)
	{
		if (Case.bCube)
		{
			const auto Vector = [](const auto* V)
			{
				return Lanes::TVec<double, 3>(V[0], V[1], V[2]);
			};
			return Lanes::GradientLevelCube(
				Case.Texture->Texture, Vector(Case.At), Vector(Values + 4), Vector(Values + 8));
		}
		const FKernelMip& Mip = Case.Texture->Mips[0];
		return std::log2(std::max(std::hypot(double(Values[4]) * Mip.SizeX, double(Values[5]) * Mip.SizeY),
			std::hypot(double(Values[8]) * Mip.SizeX, double(Values[9]) * Mip.SizeY)));
	}

	static std::optional<FTexel> SampleAt(const FSampleCase& Case, double Level)
	{
		const double Fixed = std::clamp(Level, 0.0, Case.Texture->Texture.NumMips - 1.0) * 256 + 0.5;
		if (std::abs(Fixed - std::round(Fixed)) < 0.02)
		{
			return {};
		}
		const int Snapped = int(Fixed);
		const std::optional<FTexel> First = Case.Sample(Snapped / 256);
		const std::optional<FTexel> Second = Snapped % 256 ? Case.Sample(Snapped / 256 + 1) : First;
		if (!First || !Second)
		{
			return {};
		}
		FTexel Result;
		for (size_t c = 0; c < 4; ++c)
		{
			Result[c] = (*First)[c] + Snapped % 256 / 256.0 * ((*Second)[c] - (*First)[c]);
		}
		return Result;
	}
};

TEST(ShaderSamples, EveryFormIsWhatItIsInDouble)
{
	FSamples Samples(20);
	Samples.Fill();
	Samples.Harness.RunModel(GThreads, 1);
	int Compared = 0;
	for (size_t Form = 0; Form < std::size(GForms); ++Form)
	{
		const FForm& Each = GForms[Form];
		for (size_t Thread = 0; Thread < GThreads; ++Thread)
		{
			const std::optional<FTexel> Expected = Samples.Compute(Each, Thread);
			for (size_t c = 0; Expected && c < 4; ++c)
			{
				const float Seen = Samples.Harness.BufferFloat("Out", (Form * GThreads + Thread) * 4 + c);
				// A comparison is one number, written to all four.
				ASSERT_NEAR((*Expected)[Each.Kind == FForm::Compare ? 0 : c], double(Seen), 3e-6)
					<< Each.Text << ", thread " << Thread << ", channel " << c;
				++Compared;
			}
		}
	}
	EXPECT_GT(Compared, int(GNumForms) * GThreads * 4 * 9 / 10 - 1000);
}

/** With places that are none among the others. */
TEST(ShaderSamples, KernelsOfEveryWidthHaveTheInterpretersBits)
{
	FSamples Samples(21);
	Samples.Harness.Sampler.MipBias = 0.75f; // level 0 is none, and offsets are texels of other mips
	const float Strange[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
		-std::numeric_limits<float>::infinity(), 0.0f, -0.0f, 1.0f};
	for (size_t i = 0; i < Samples.In.size(); i += 7)
	{
		Samples.In[i] = Strange[i / 7 % 6];
	}
	Samples.Fill();
	Samples.Harness.RunModel(GThreads, 1);
	const std::vector<uint32_t> Expected = Samples.Harness.Buffers.at("Out");
	const auto Compare = [&](const std::string& What)
	{
		for (size_t i = 0; i < Expected.size(); ++i)
		{
			float A, B;
			std::memcpy(&A, &Expected[i], 4);
			std::memcpy(&B, &Samples.Harness.Buffers.at("Out")[i], 4);
			ASSERT_TRUE(SameFloat(A, B)) << What << ", form " << i / 4 / GThreads << ", thread " << i / 4 % GThreads
										 << ": " << A << " and " << B;
		}
	};
	for (const int32_t Lanes : GetLaneCounts())
	{
		Samples.Fill();
		const std::shared_ptr<const FCompiledShader> Shader = Samples.Harness.Run(Lanes, GThreads, 1);
		Compare(std::to_string(Lanes) + " lanes");
		EXPECT_EQ(int32_t(GNumForms) + 3, Shader->Reflection.StaticSamples); // offsets of the thread: four gathers
	}
	Samples.Fill();
	Samples.Harness.RunInspected(GThreads, 1);
	Compare("looked into");
}

TEST(ShaderSamples, WavesHaveTheInterpretersBits)
{
	FSamples Samples(24, true);
	Samples.Harness.WaveSize = 8; // by two packs of four lanes
	Samples.Fill();
	Samples.Harness.RunModel(GThreads, 1);
	const std::vector<uint32_t> Expected = Samples.Harness.Buffers.at("Out");
	Samples.Fill();
	Samples.Harness.Run(4, GThreads, 1);
	EXPECT_EQ(Expected, Samples.Harness.Buffers.at("Out"));
}

TEST(ShaderSamples, DoubleLanesHaveTheInterpretersBits)
{
	FSamples Samples(22);
	Samples.Fill();
	Samples.Harness.Run(GetWidestLanes(true), GThreads, 1, 1, true);
	const std::vector<uint32_t> Expected = Samples.Harness.Buffers.at("Out");
	Samples.Fill();
	Samples.Harness.RunInspected(GThreads, 1, 1, true);
	EXPECT_EQ(Expected, Samples.Harness.Buffers.at("Out"));
}

TEST(ShaderSamples, SizesOfCubesAreThoseOfAFaceAndTheirNumber)
{
	FMips C(ETexelStorage::R32_FLOAT, 8, 8, 6, 4);
	FMips CA(ETexelStorage::R32_FLOAT, 4, 4, 18, 2);
	FShaderHarness Harness("TextureCube C; TextureCubeArray CA; RWStructuredBuffer<uint> Out;\n"
						   "[numthreads(1, 1, 1)] void MainCS() { uint W, H, N, L;\n"
						   "C.GetDimensions(1, W, H, L); Out[0] = W; Out[1] = H; Out[2] = L;\n"
						   "CA.GetDimensions(0, W, H, N, L); Out[3] = W; Out[4] = H; Out[5] = N; Out[6] = L; }\n",
		"MainCS", EShaderStage::Compute);
	Harness.Views = {{"C", C.Texture}, {"CA", CA.Texture}};
	const std::vector<uint32_t> Expected = {4, 4, 4, 4, 4, 3, 2};
	Harness.Buffers["Out"].assign(7, 0);
	Harness.Run(4, 1, 1);
	EXPECT_EQ(Expected, Harness.Buffers["Out"]);
	Harness.Buffers["Out"].assign(7, 0);
	Harness.RunModel(1, 1);
	EXPECT_EQ(Expected, Harness.Buffers["Out"]);
}

/** A comparison of a pixel shader has no level of its own in SPIR-V. */
TEST(ShaderSamples, PixelShadersCompareToo)
{
	FMips D(ETexelStorage::R32_FLOAT, 2, 1);
	D.Write({0.25, 0, 0, 0}, 0, 0);
	D.Write({0.75, 0, 0, 0}, 1, 0);
	FShaderHarness Harness("Texture2D<float> D; SamplerComparisonState SC;\nvoid MainPS(float4 P : SV_POSITION, out "
						   "float4 Out : SV_Target0) { Out = D.SampleCmp(SC, P.xy / float2(4, 1), 0.5); }\n",
		"MainPS", EShaderStage::Pixel);
	Harness.Views["D"] = D.Texture;
	Harness.Sampler.Compare = EKernelCompare::Less;
	Harness.Targets.emplace_back(4, 1);
	Harness.Run(4, 4, 1);
	const float Expected[] = {0, 0.25f, 0.75f, 1};
	for (int32_t X = 0; X < 4; ++X)
	{
		EXPECT_EQ(Expected[X], Harness.Targets[0].Texel(X, 0)[0]);
	}
}

TEST(ShaderSamples, ReflectionTellsCubesAndSamplersThatCompare)
{
	FSamples Samples(23);
	Samples.Harness.Request.Lanes = {false, 4, 32};
	const FShaderReflection Reflection = CompileShader(Samples.Harness.Request)->Reflection;
	for (const FShaderResource& Texture : Reflection.Textures)
	{
		EXPECT_EQ(Texture.Name.find('C') != std::string::npos, Texture.Dimension == EShaderDimension::TextureCube)
			<< Texture.Name;
	}
	ASSERT_EQ(2u, Reflection.Samplers.size());
	for (const FShaderResource& Sampler : Reflection.Samplers)
	{
		EXPECT_EQ(Sampler.Name == "SC", Sampler.bCompares);
	}
}

} // namespace
} // namespace Drydock::Test
