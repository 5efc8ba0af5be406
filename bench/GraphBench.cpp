// What a graph costs besides its passes' work: microseconds of processor time and kilobytes a pass, to declare, to
// compile, to run and to destroy graphs of passes that do nothing. Prints a table in Markdown; the least of several
// repetitions, more of them where the graph is small.
//
//     bench_graph [NUMBER OF PASSES]...
#include "GlobalShader.h"
#include "RHICommandList.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphObserver.h"
#include "RenderTargetPool.h"
#include "ShaderParameterStruct.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <malloc.h>
#include <random>
#include <vector>

using namespace Drydock;

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FComputeParameters, )
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, First)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Second)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Output)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FRasterParameters, )
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

enum class EShape
{
	Chain,      // each pass reads the texture of the one before
	Culled,     // the same, and nobody reads the last
	RandomNear, // each pass also reads one of the last 50 textures
	RandomFar,  // or any earlier one: long lives
	Raster,     // all passes draw to one target
};

/** Processor time of the process in microseconds: what else runs on the machine does not count. */
double GetMicroseconds()
{
	timespec Time;
	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &Time);
	return double(Time.tv_sec) * 1e6 + double(Time.tv_nsec) * 1e-3;
}

struct FCost
{
	double Build = std::numeric_limits<double>::max();
	double Compile = std::numeric_limits<double>::max();
	double Run = std::numeric_limits<double>::max();
	double Free = std::numeric_limits<double>::max();
	double Bytes = 0.0;
};

struct FCompileWatch final : IRDGObserver
{
	double Compiled = 0.0;
	void OnGraphCompiled(const FRDGCompiledGraph&) override { Compiled = GetMicroseconds(); }
};

FRDGTextureRef AddTexture(FRDGBuilder& GraphBuilder, int Index)
{
	const ETextureCreateFlags Flags = TexCreate_ShaderResource | TexCreate_UAV | TexCreate_RenderTargetable;
	return GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(FIntPoint(16 + Index % 7 * 16, 16), PF_FloatRGBA, FClearValueBinding::None, Flags),
		TEXT("Texture"));
}

/** Returns the texture of the last pass. */
FRDGTextureRef AddPasses(FRDGBuilder& GraphBuilder, EShape Shape, int Num)
{
	std::mt19937 Random(1);
	std::vector<FRDGTextureRef> Textures = {AddTexture(GraphBuilder, 0)};
	for (int Pass = 0; Pass < Num; ++Pass)
	{
		if (Shape == EShape::Raster)
		{
			auto* Parameters = GraphBuilder.AllocParameters<FRasterParameters>();
			Parameters->RenderTargets[0] = FRenderTargetBinding(
				Textures[0], Pass == 0 ? ERenderTargetLoadAction::ENoAction : ERenderTargetLoadAction::ELoad);
			GraphBuilder.AddPass(
				RDG_EVENT_NAME("Pass %d", Pass), Parameters, ERDGPassFlags::Raster, [](FRHICommandList&) {});
			continue;
		}
		auto* Parameters = GraphBuilder.AllocParameters<FComputeParameters>();
		const size_t Farthest = Shape == EShape::RandomFar ? Textures.size() : std::min<size_t>(Textures.size(), 50);
		if (Pass > 0)
		{
			Parameters->First = Textures.back();
		}
		if (Pass > 0 && (Shape == EShape::RandomFar || Shape == EShape::RandomNear))
		{
			Parameters->Second = Textures[Textures.size() - 1 - Random() % (Farthest - 1)];
		}
		Textures.push_back(AddTexture(GraphBuilder, Pass));
		Parameters->Output = GraphBuilder.CreateUAV(Textures.back());
		GraphBuilder.AddPass(
			RDG_EVENT_NAME("Pass %d", Pass), Parameters, ERDGPassFlags::Compute, [](FRHIComputeCommandList&) {});
	}
	return Textures.back();
}

FCost Measure(EShape Shape, int Num)
{
	FCost Cost;
	const int NumRepetitions = Num < 200 ? 2000 : Num < 5000 ? 20 : 3;
	for (int Repetition = 0; Repetition < NumRepetitions; ++Repetition)
	{
		const size_t BytesBefore = mallinfo2().uordblks;
		TRefCountPtr<IPooledRenderTarget> Extracted;
		FCompileWatch Watch;
		const double Begin = GetMicroseconds();
		auto GraphBuilder =
			std::make_unique<FRDGBuilder>(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Bench"));
		GraphBuilder->SetObserver(&Watch);
		const FRDGTextureRef Last = AddPasses(*GraphBuilder, Shape, Num);
		if (Shape != EShape::Culled)
		{
			GraphBuilder->QueueTextureExtraction(Last, &Extracted);
		}
		const double Built = GetMicroseconds();
		GraphBuilder->Execute();
		const double Ran = GetMicroseconds();
		const size_t BytesAfter = mallinfo2().uordblks;
		const double BeforeFree = GetMicroseconds();
		GraphBuilder.reset();
		const double Freed = GetMicroseconds();
		Cost.Build = std::min(Cost.Build, Built - Begin);
		Cost.Compile = std::min(Cost.Compile, Watch.Compiled - Built);
		Cost.Run = std::min(Cost.Run, Ran - Watch.Compiled);
		Cost.Free = std::min(Cost.Free, Freed - BeforeFree);
		Cost.Bytes = double(BytesAfter) - double(BytesBefore);
	}
	return Cost;
}

} // namespace

int main(int NumArguments, char** Arguments)
{
	std::vector<int> Sizes;
	for (int Index = 1; Index < NumArguments; ++Index)
	{
		Sizes.push_back(std::max(1, std::atoi(Arguments[Index])));
	}
	if (Sizes.empty())
	{
		Sizes = {1, 60, 1000, 10000, 30000};
	}
	struct FRow
	{
		const char* Name;
		EShape Shape;
	};
	const FRow Rows[] = {{"chain, a texture each", EShape::Chain}, {"chain that is culled", EShape::Culled},
		{"reads among the last 50", EShape::RandomNear}, {"reads anywhere", EShape::RandomFar},
		{"raster on one target", EShape::Raster}};
	std::printf("Microseconds of processor time a pass; kilobytes a pass that the builder holds at its end.\n\n"
				"| graph | passes | build | compile | build and compile, all passes | run | free | KB |\n"
				"|---|--:|--:|--:|--:|--:|--:|--:|\n");
	for (const FRow& Row : Rows)
	{
		for (const int Num : Sizes)
		{
			const FCost Cost = Measure(Row.Shape, Num);
			std::printf("| %s | %d | %.2f | %.2f | %.1f | %.2f | %.2f | %.1f |\n", Row.Name, Num, Cost.Build / Num,
				Cost.Compile / Num, Cost.Build + Cost.Compile, Cost.Run / Num, Cost.Free / Num,
				Cost.Bytes * 1e-3 / Num);
		}
	}
	return 0;
}
