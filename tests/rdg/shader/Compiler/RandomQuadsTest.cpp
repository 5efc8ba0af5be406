// Random pixel shaders that take derivatives, in uniform and divergent flow, sample textures with mips and discard
// pixels: the compiled kernel and the interpreter, also of the program with its functions, agree bit for bit.
#include <gtest/gtest.h>

#include "RandomPrograms.h"

#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t Width = 21; // neither even nor a multiple of a pack
constexpr int32_t Height = 5;

class FQuadProgram
{
public:
	explicit FQuadProgram(uint32_t Seed)
		: Random(Seed)
	{
	}

	std::string Make()
	{
		const std::string Helper = "float Bend(float A, float B)\n{\n\tif (A > B)\n\t{\n\t\treturn ddx(A) + " +
								   Number() + ";\n\t}\n\treturn B * " + Number() + " + fwidth(B);\n}\n";
		std::string Body;
		for (int i = 0; i < 7; ++i)
		{
			Body += Statement(1);
		}
		return "Texture2D Source;\nSamplerState SourceSampler;\nfloat4 Uniforms;\nRWStructuredBuffer<uint> Sums;\n" +
			   Helper +
			   "void MainPS(float4 P : SV_POSITION, float4 UV : TEXCOORD0, out float4 First : SV_Target0, "
			   "out float4 Second : SV_Target1)\n{\n"
			   "\tfloat V[3] = {frac(P.x * 0.37 + P.y * 0.73) * Uniforms.x, UV.x, UV.w};\n"
			   "\tuint N = uint(P.x) * 7 + uint(P.y) * 3;\n" +
			   Body +
			   "\tFirst = float4(V[0], V[1], V[2], ddy(V[0] + V[1]));\n"
			   "\tSecond = float4(ddx_fine(V[2]), float(N & 4095u), ddy_fine(V[1]), 1);\n"
			   "\tInterlockedAdd(Sums[N & 7], 1);\n}\n";
	}

private:
	uint32_t Choose(uint32_t Limit) { return uint32_t(Random() % Limit); }
	std::string Number()
	{
		static const char* const Numbers[] = {"Uniforms.x", "Uniforms.y", "Uniforms.z", "Uniforms.w", "0.37", "3.0"};
		return Numbers[Choose(6)];
	}
	std::string Value() { return "V[" + std::to_string(Choose(3)) + "]"; }
	std::string Expression()
	{
		const char* const Operators[] = {" + ", " * ", " - "};
		switch (Choose(5))
		{
		case 0:
			return "Bend(" + Value() + ", " + Value() + ")";
		case 1:
			return "frac(" + Value() + ") * " + Number();
		case 2:
			return "min(" + Value() + ", abs(" + Value() + ") + " + Number() + ")";
		default:
			return "clamp(" + Value() + Operators[Choose(3)] + (Choose(2) ? Number() : Value()) + ", -8, 8)";
		}
	}
	std::string OfNeighbours()
	{
		static const char* const Derivatives[] = {"ddx", "ddy", "fwidth", "ddx_fine", "ddy_fine", "ddx_coarse",
			"ddy_coarse", "QuadReadAcrossX", "QuadReadAcrossY", "QuadReadAcrossDiagonal"};
		switch (Choose(6))
		{
		case 0:
			return "Source.Sample(SourceSampler, float2(" + Value() + ", " + Value() + ")).x";
		case 1:
			return "Source.SampleBias(SourceSampler, float2(" + Value() + ", UV.y), " + Number() + ").y";
		case 2:
			return "clamp(Source.CalculateLevelOfDetail(SourceSampler, float2(" + Value() + ", " + Value() +
				   ")), -8, 8)";
		default:
			return std::string(Derivatives[Choose(10)]) + "(" + Value() + (Choose(2) ? ")" : " * " + Number() + ")");
		}
	}
	std::string Condition()
	{
		switch (Choose(4))
		{
		case 0:
			return "Uniforms.x > " + Number();
		case 1:
			return "(N & " + std::to_string(1 + Choose(7)) + "u) != 0u";
		default:
			return Value() + " > " + Number() + " - 1";
		}
	}
	static std::string Tabs(int Depth) { return std::string(size_t(Depth), '\t'); }
	std::string Block(int Depth)
	{
		std::string Text = Tabs(Depth) + "{\n";
		for (uint32_t i = 0; i < 1 + Choose(3); ++i)
		{
			Text += Statement(Depth + 1);
		}
		return Text + Tabs(Depth) + "}\n";
	}

	std::string Statement(int Depth)
	{
		const std::string Tab = Tabs(Depth);
		const bool bNest = Depth < 4;
		switch (Choose(10))
		{
		case 0:
		case 1:
		case 2:
			return Tab + Value() + " = " + OfNeighbours() + ";\n";
		case 3:
			if (bNest)
			{
				const std::string Counter = "k" + std::to_string(NumCounters++);
				const std::string Turns = Choose(2) ? std::to_string(1 + Choose(3)) + "u" : "(N & 3u)";
				const std::string Leave = Choose(2)
											  ? Tab + "\tif (" + Condition() + ")\n" + Tab + "\t{\n" + Tab + "\t\t" +
													(Choose(2) ? "break;\n" : "continue;\n") + Tab + "\t}\n"
											  : std::string();
				return Tab + "[loop] for (uint " + Counter + " = 0; " + Counter + " < " + Turns + "; ++" + Counter +
					   ")\n" + Tab + "{\n" + Leave + Block(Depth + 1) + Tab + "}\n";
			}
			break;
		case 4:
		case 5:
			if (bNest)
			{
				return Tab + "if (" + Condition() + ")\n" + Block(Depth) +
					   (Choose(2) ? Tab + "else\n" + Block(Depth) : std::string());
			}
			break;
		case 6:
			if (Choose(3) == 0)
			{
				return Choose(2)
						   ? Tab + "clip(" + Value() + " + " + Number() + ");\n"
						   : Tab + "if (" + Value() + " > 3)\n" + Tab + "{\n" + Tab + "\tdiscard;\n" + Tab + "}\n";
			}
			return Tab + "N = N * 5u + uint(abs(" + Value() + "));\n";
		default:
			break;
		}
		return Tab + Value() + " = " + Expression() + ";\n";
	}

	std::mt19937 Random;
	uint32_t NumCounters = 0;
};

void Fill(FShaderHarness& Harness, uint32_t Seed)
{
	std::mt19937 Random(Seed);
	const auto Draw = [&Random]
	{
		return float(int32_t(Random() % 2048) - 1024) / 256.0f;
	};
	FTestTexture& Source = Harness.Textures["Source"] = FTestTexture(16, 16, false, 5);
	for (int32_t Mip = 0; Mip < 5; ++Mip)
	{
		const int32_t Size = FTestTexture::GetSize(16, Mip);
		for (int32_t i = 0; i < Size * Size * 4; ++i)
		{
			Source.Texel(i / 4 % Size, i / 4 / Size, Mip)[i % 4] = Draw();
		}
	}
	static constexpr EKernelFilter Filters[] = {
		EKernelFilter::Point, EKernelFilter::Bilinear, EKernelFilter::Trilinear};
	Harness.Sampler.Filter = Filters[Seed % 3];
	Harness.Sampler.AddressU = EKernelAddress::Wrap;
	Harness.SetFloats("Uniforms", {Draw(), Draw(), Draw(), Draw()});
	Harness.Buffers["Sums"].assign(8, 0);
	Harness.Interpolants[0] = {{0.5, 0.25, 1, -1}, {0.0625, 0, 0.5, 0.25}, {0, 0.125, 0.25, -0.5}};
	Harness.Targets.assign(2, FTestTexture(Width, Height));
	Harness.Request.bQuads = true;
}

/** "target 1, pixel (3, 4): 1 and 2"; empty: they are the same. */
std::string FindDifference(FShaderHarness& A, FShaderHarness& B)
{
	for (int32_t i = 0; i < 2 * Width * Height * 4; ++i)
	{
		const int32_t Pixel = i / 4 % (Width * Height);
		const size_t Target = size_t(i / 4 / (Width * Height));
		const float First = A.Targets[Target].Texel(Pixel % Width, Pixel / Width)[i % 4];
		const float Second = B.Targets[Target].Texel(Pixel % Width, Pixel / Width)[i % 4];
		if (!SameFloat(First, Second))
		{
			return "target " + std::to_string(Target) + ", pixel (" + std::to_string(Pixel % Width) + ", " +
				   std::to_string(Pixel / Width) + "), channel " + std::to_string(i % 4) + ": " +
				   std::to_string(First) + " and " + std::to_string(Second);
		}
	}
	return A.Buffers["Sums"] == B.Buffers["Sums"] ? std::string() : "the counts of pixels";
}

} // namespace

class FRandomQuads : public testing::TestWithParam<int>
{
};

TEST_P(FRandomQuads, KernelsAgreeWithTheModelBitForBit)
{
	const uint32_t Seed = uint32_t(GetParam());
	ExpectFormsAgree(
		Seed, FQuadProgram(Seed).Make(), EShaderStage::Pixel, Width, Height,
		[Seed](FShaderHarness& Harness) { Fill(Harness, Seed); }, &FindDifference);
}

INSTANTIATE_TEST_SUITE_P(Seeds, FRandomQuads, RandomSeeds(25));
