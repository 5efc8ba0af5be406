// A trace is what the kernel did: for random pixels of every pass of every shipped config, what the interpreter hands
// over is, once its format has rounded it, the texel that the kernel wrote, bit for bit.
#include <gtest/gtest.h>

#include "Inspect/TraceCapture.h"

#include "Diagnostics.h"
#include "PixelFormatConversion.h"
#include "Run/Run.h"
#include "Sandbox.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "TileExecutor.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

namespace
{

using namespace Drydock;

constexpr int PixelsPerDispatch = 20;

/** The texel of a mip as its bytes. */
std::vector<uint8_t> ReadBytes(const FKernelTexture& Texture, int64_t X, int64_t Y, int64_t Z)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const int64_t Size = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	const uint8_t* const At = Mip.Data + Z * Mip.SlicePitch + Y * Mip.RowPitch + X * Size;
	return {At, At + Size};
}

/** As a kernel of this arithmetic stores it. */
template<typename Real>
std::vector<uint8_t> Encode(const FKernelTexture& Texture, const std::vector<double>& Color)
{
	Real RGBA[4] = {0, 0, 0, 1};
	for (size_t c = 0; c < 4 && c < Color.size(); ++c)
	{
		RGBA[c] = Real(Color[c]);
	}
	std::vector<uint8_t> Bytes(size_t(GetTexelStorageInfo(Texture.Storage).BytesPerTexel));
	const FScopedDenormals Denormals(sizeof(Real) == sizeof(double) ? EDenormals::Keep : EDenormals::Flush);
	EncodeTexel(Texture.Storage, RGBA, Bytes.data(), Texture.bSaturateStore != 0);
	return Bytes;
}

/** Traces random threads before each dispatch, and compares with what is there after it. */
template<typename Real>
class TComparison final : public IDispatchObserver
{
public:
	static constexpr bool bDouble = sizeof(Real) == sizeof(double);

	void BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) override
	{
		Expected.clear();
		std::unique_ptr<FInspectedShader>& Inspected = Shaders[Shader.Permutation];
		if (!Inspected)
		{
			const FShaderRef Permutation(Shader.Permutation);
			Inspected = std::make_unique<FInspectedShader>(
				MakeShaderCompileRequest(Permutation, Permutation.GetRootParametersMetadata()), Shader.GetReflection());
			NumInlined += !Inspected->HasVariables();
		}
		const FSandbox Sandbox(Args, Shader.GetReflection());
		const auto Draw = [this](int32_t Min, int32_t Max)
		{
			return int32_t(Random() % uint32_t(std::max(1, Max - Min))) + Min;
		};
		for (int i = 0; i < PixelsPerDispatch; ++i)
		{
			const int32_t At[3] = {
				Draw(Whole.MinX, Whole.MaxX), Draw(Whole.MinY, Whole.MaxY), Draw(Whole.MinZ, Whole.MaxZ)};
			const FScopedDenormals Denormals(bDouble ? EDenormals::Keep : EDenormals::Flush);
			const FPixelTrace Trace = TracePixel(*Inspected, Sandbox.GetArgs(), At, bDouble, 1'000'000'000);
			AddTargets(Args, Trace, At);
			AddStores(Shader, *Inspected, Trace);
			++NumTraces;
		}
	}

	void AfterDispatch(const FBoundShader& Shader, const FKernelArgs&, const FKernelTile&) override
	{
		for (const auto& [Where, Bytes] : Expected)
		{
			const auto& [Texture, X, Y, Z] = Where;
			++NumTexels;
			if (ReadBytes(*Texture, X, Y, Z) != Bytes && Differences.size() < 10)
			{
				Differences.push_back(Shader.Name + " at (" + std::to_string(X) + ", " + std::to_string(Y) + ", " +
									  std::to_string(Z) + ")");
			}
		}
	}

	uint64_t NumTraces = 0;
	uint64_t NumTexels = 0;
	int NumInlined = 0;
	std::vector<std::string> Differences;

private:
	void AddTargets(const FKernelArgs& Args, const FPixelTrace& Trace, const int32_t (&At)[3])
	{
		for (size_t Target = 0; Target < Trace.Targets.size() && int32_t(Target) < Args.NumTargets; ++Target)
		{
			const FKernelTarget& View = Args.Targets[Target];
			if (!View.bBlend && View.WriteMask == 15)
			{
				Expected[{&View.Texture, At[0], At[1], 0}] = Encode<Real>(View.Texture, Trace.Targets[Target]);
			}
		}
	}

	/** Of textures whose components are floats; the kernel must not store there twice. */
	void AddStores(const FBoundShader& Shader, const FInspectedShader& Inspected, const FPixelTrace& Trace)
	{
		const std::vector<FShaderResource>& Resources = Shader.GetReflection().RWTextures;
		for (const FTraceLine& Line : Trace.Lines)
		{
			for (const FTraceEvent& Event : Line.Events)
			{
				for (size_t Slot = 0; Slot < Resources.size() && Event.Kind == ETraceEvent::Store; ++Slot)
				{
					const bool bFloat = Inspected.GetModule().GetScalarKind(Event.Value.Type, 0) == ESpirvType::Float;
					if (Resources[Slot].Name == Event.Name && bFloat && Event.Texel.size() >= 2)
					{
						const FKernelTexture& View = Shader.RWTextures[Slot];
						const int64_t Z = Event.Texel.size() > 2 ? Event.Texel[2] : 0;
						const bool bInside = Event.Texel[0] < View.Mips[0].SizeX && Event.Texel[1] < View.Mips[0].SizeY;
						if (bInside)
						{
							Expected[{&View, Event.Texel[0], Event.Texel[1], Z}] =
								Encode<Real>(View, Event.Value.Reals);
						}
					}
				}
			}
		}
	}

	std::mt19937 Random{19};
	std::map<FShader*, std::unique_ptr<FInspectedShader>> Shaders;
	std::map<std::tuple<const FKernelTexture*, int64_t, int64_t, int64_t>, std::vector<uint8_t>> Expected;
};

std::vector<std::string> FindConfigs()
{
	std::vector<std::string> Found;
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/configs"))
	{
		std::ifstream Stream(Entry.path());
		std::stringstream Text;
		Text << Stream.rdbuf();
		if (Entry.path().extension() == ".json" && Text.str().find("\"scene\"") != std::string::npos)
		{
			Found.push_back(Entry.path().string());
		}
	}
	std::sort(Found.begin(), Found.end());
	return Found;
}

/** Texels that were compared. */
template<typename Real>
uint64_t CompareShippedConfigs()
{
	uint64_t NumTexels = 0;
	for (const std::string& Config : FindConfigs())
	{
		TComparison<Real> Comparison;
		FRunOptions Options;
		Options.ConfigFile = Config;
		Options.Variables = {std::string("r.Drydock.Precision=") + (Comparison.bDouble ? "1" : "0")};
		{
			const FScopedDispatchObserver Scope(Comparison);
			RunConfig(Options);
		}
		EXPECT_EQ(std::vector<std::string>{}, Comparison.Differences) << Config;
		EXPECT_EQ(0, Comparison.NumInlined) << Config << ": a shader without its variables";
		NumTexels += Comparison.NumTexels;
	}
	return NumTexels;
}

TEST(TraceCapture, IsWhatTheKernelsOfEveryShippedConfigDid)
{
	EXPECT_GE(CompareShippedConfigs<float>(), 10000u);
}

TEST(TraceCapture, InDoubleIsWhatTheKernelsInDoubleDid)
{
	EXPECT_GE(CompareShippedConfigs<double>(), 10000u);
}

FTraceRequest Ask(const std::string& Pass, int32_t X, int32_t Y)
{
	FTraceRequest Request;
	Request.Pass = Pass;
	Request.At = {X, Y, 0};
	return Request;
}

std::vector<FCapturedTrace> TraceToonBloom(const FTraceRequest& Request)
{
	FTraceCapture Capture(Request);
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/toon_bloom.json";
	const FScopedDispatchObserver Scope(Capture);
	RunConfig(Options);
	return Capture.GetTraces();
}

std::string ErrorOf(const FTraceRequest& Request)
{
	try
	{
		TraceToonBloom(Request);
	}
	catch (const FError& Error)
	{
		return Error.what();
	}
	return {};
}

TEST(TraceCapture, SaysWhatAPixelOfThePassDidInWords)
{
	const FTraceRequest Request = Ask("Tonemap*", 100, 50);
	const std::vector<FCapturedTrace> Traces = TraceToonBloom(Request);
	ASSERT_EQ(1u, Traces.size());
	const std::string Text = MakeTraceText(Traces[0], Request);
	EXPECT_NE(std::string::npos, Text.find("pixel 100,50")) << Text;
	EXPECT_NE(std::string::npos, Text.find("/Engine/Private/PostProcessTonemap.usf")) << Text;
	EXPECT_NE(std::string::npos, Text.find("sample ")) << Text;
	EXPECT_NE(std::string::npos, Text.find("SV_Target0 = (")) << Text;
	const std::string Json = MakeTraceJson(Traces, Request);
	EXPECT_NE(std::string::npos, Json.find("\"event\": \"sample\"")) << Json.substr(0, 500);
}

TEST(TraceCapture, APassThatIsNotThereIsNamedWithTheNearest)
{
	const std::string Message = ErrorOf(Ask("Tonemep", 0, 0));
	EXPECT_NE(std::string::npos, Message.find("--pass")) << Message;
	EXPECT_NE(std::string::npos, Message.find("did you mean 'Tonemap")) << Message;
}

TEST(TraceCapture, APixelOutsideIsToldWhatThereIs)
{
	const std::string Message = ErrorOf(Ask("Tonemap*", 100000, 0));
	EXPECT_NE(std::string::npos, Message.find("pixel 100000,0 is outside of what the pass draws: Tonemap")) << Message;
}

TEST(TraceCapture, FloatAndDoublePartWhereTheyDoFirst)
{
	const auto MakeTrace = [](std::initializer_list<double> Values)
	{
		FPixelTrace Trace;
		int Line = 1;
		for (const double Value : Values)
		{
			FTraceEvent Event;
			Event.Value.Reals = {Value};
			Trace.Lines.push_back({"/X.usf", Line++, "Main", 0, {Event}});
		}
		return Trace;
	};
	const FPixelTrace Float = MakeTrace({1, 2, 3.1, 9});
	EXPECT_FALSE(FindDifference(Float, Float, 0));
	const std::optional<FTraceDifference> Found = FindDifference(Float, MakeTrace({1, 2.0001, 3, 8}), 1e-2);
	ASSERT_TRUE(Found);
	EXPECT_EQ(2u, Found->Line);
	EXPECT_EQ(3.1, Found->Float);
	const std::optional<FTraceDifference> Path = FindDifference(Float, MakeTrace({1, 2}), 1e-2);
	ASSERT_TRUE(Path && Path->bOtherPath);
	EXPECT_EQ(2u, Path->Line);
}

} // namespace
