// Random graphs: whatever the mode, what leaves the graph is the same, bit for bit. Each graph is made from its seed,
// so a failure can be repeated.
#include <gtest/gtest.h>

#include "DispatchReuse.h"
#include "GraphTestBuilder.h"

#include <cstring>
#include <random>
#include <set>

using namespace Drydock;

namespace
{

/** Reads and writes of one pass: textures by number, mip 0 or 1. */
struct FPassPlan
{
	struct FMip
	{
		int32 Texture;
		int32 Mip;

		auto operator<=>(const FMip&) const = default;
	};

	std::vector<FMip> Reads;
	std::vector<FMip> Writes;
	bool bRaster = false;
	bool bAsync = false;
	bool bNeverCull = false;
};

struct FGraphPlan
{
	int32 NumTextures = 0;
	std::set<int32> External;
	std::set<int32> Extracted;
	std::vector<FPassPlan> Passes;
};

/** Only mips that an earlier pass wrote are read: everything else has no defined value. */
FGraphPlan MakePlan(uint32 Seed)
{
	std::mt19937 Random(Seed);
	const auto Below = [&Random](int32 Count)
	{
		return int32(Random() % uint32(Count));
	};
	FGraphPlan Plan;
	Plan.NumTextures = 2 + Below(10);
	std::vector<FPassPlan::FMip> Written;
	for (int32 Texture = 0; Texture < Plan.NumTextures; ++Texture)
	{
		if (Below(6) == 0)
		{
			Plan.External.insert(Texture);
			Written.push_back({Texture, 0});
			Written.push_back({Texture, 1});
		}
	}
	const int32 NumPasses = 1 + Below(20);
	for (int32 Index = 0; Index < NumPasses; ++Index)
	{
		FPassPlan& Pass = Plan.Passes.emplace_back();
		std::set<FPassPlan::FMip> Touched;
		const int32 NumWrites = 1 + Below(2);
		for (int32 Write = 0; Write < NumWrites; ++Write)
		{
			const FPassPlan::FMip Mip{Below(Plan.NumTextures), Below(2)};
			if (Touched.insert(Mip).second)
			{
				Pass.Writes.push_back(Mip);
			}
		}
		const int32 NumReads = Below(4);
		for (int32 Read = 0; Read < NumReads && !Written.empty(); ++Read)
		{
			const FPassPlan::FMip Mip = Written[size_t(Below(int32(Written.size())))];
			if (Touched.insert(Mip).second)
			{
				Pass.Reads.push_back(Mip);
			}
		}
		Pass.bRaster = Below(3) == 0;
		Pass.bAsync = !Pass.bRaster && Below(4) == 0;
		Pass.bNeverCull = Below(12) == 0;
		Written.insert(Written.end(), Pass.Writes.begin(), Pass.Writes.end());
	}
	// Textures with both mips written may leave the graph.
	for (int32 Texture = 0; Texture < Plan.NumTextures; ++Texture)
	{
		const auto IsWritten = [&](int32 Mip)
		{
			return std::find(Written.begin(), Written.end(), FPassPlan::FMip{Texture, Mip}) != Written.end();
		};
		if (IsWritten(0) && IsWritten(1) && Below(3) == 0)
		{
			Plan.Extracted.insert(Texture);
		}
	}
	return Plan;
}

std::string GetName(int32 Texture)
{
	return "T" + std::to_string(Texture);
}

void AddPlannedPass(FGraphTest& Graph, const FPassPlan& Plan, int32 Index)
{
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestRasterParameters>();
	for (size_t Read = 0; Read < Plan.Reads.size(); ++Read)
	{
		Parameters->Common.SRVs[int32(Read)] = Graph.Builder->CreateSRV(FRDGTextureSRVDesc::CreateForMipLevel(
			Graph.Texture(GetName(Plan.Reads[Read].Texture), 2), Plan.Reads[Read].Mip));
	}
	for (size_t Write = 0; Write < Plan.Writes.size(); ++Write)
	{
		FRDGTextureRef Texture = Graph.Texture(GetName(Plan.Writes[Write].Texture), 2);
		if (Plan.bRaster)
		{
			Parameters->RenderTargets[uint32(Write)] =
				FRenderTargetBinding(Texture, ERenderTargetLoadAction::ENoAction, uint8(Plan.Writes[Write].Mip));
		}
		else
		{
			Parameters->Common.UAVs[int32(Write)] =
				Graph.Builder->CreateUAV(FRDGTextureUAVDesc(Texture, uint8(Plan.Writes[Write].Mip)));
		}
	}
	const auto Work = [Parameters, Index](FRHICommandListImmediate&)
	{
		float Sum = float(Index + 1);
		for (FRDGTextureSRV* View : Parameters->Common.SRVs)
		{
			Sum = View ? Sum * 0.5f + View->GetRHI()->GetTexture()->ReadTexel(1, 0, View->Desc.MipLevel).R : Sum;
		}
		const auto Fill = [Sum](FRHITexture* Texture, int32 Mip)
		{
			const FIntVector Size = Texture->GetMipDimensions(uint8(Mip));
			for (int32 Y = 0; Y < Size.Y; ++Y)
			{
				for (int32 X = 0; X < Size.X; ++X)
				{
					Texture->WriteTexel(X, Y, FLinearColor(Sum + float(X) * 0.125f - float(Y), 0, 0, 0), Mip);
				}
			}
		};
		for (FRDGTextureUAV* View : Parameters->Common.UAVs)
		{
			if (View)
			{
				Fill(View->GetRHI()->GetTexture(), View->Desc.MipLevel);
			}
		}
		Parameters->RenderTargets.Enumerate(
			[&](const FRenderTargetBinding& Binding) { Fill(Binding.GetTexture()->GetRHI(), Binding.GetMipIndex()); });
	};
	const ERDGPassFlags Keep = Plan.bNeverCull ? ERDGPassFlags::NeverCull : ERDGPassFlags::None;
	const ERDGPassFlags Kind = Plan.bRaster  ? ERDGPassFlags::Raster
							   : Plan.bAsync ? ERDGPassFlags::AsyncCompute
											 : ERDGPassFlags::Compute;
	if (Plan.bRaster)
	{
		Graph.Builder->AddPass(RDG_EVENT_NAME("P%d", Index), Parameters, Kind | Keep, Work);
	}
	else
	{
		Graph.Builder->AddPass(RDG_EVENT_NAME("P%d", Index), &Parameters->Common, Kind | Keep, Work);
	}
}

void Build(FGraphTest& Graph, const FGraphPlan& Plan)
{
	for (int32 Texture = 0; Texture < Plan.NumTextures; ++Texture)
	{
		const std::string Name = GetName(Texture);
		if (Plan.External.count(Texture))
		{
			const TRefCountPtr<FRHITexture> RHITexture(new FRHITexture(FGraphTest::MakeDesc(2), Graph.KeepName(Name)));
			RHITexture->Fill(FLinearColor(float(Texture) * 3.0f, 0, 0, 0));
			Graph.Pooled[Name] = CreateRenderTarget(RHITexture, Graph.KeepName(Name));
			Graph.Textures[Name] = Graph.Builder->RegisterExternalTexture(Graph.Pooled[Name], Graph.KeepName(Name));
		}
	}
	for (size_t Index = 0; Index < Plan.Passes.size(); ++Index)
	{
		AddPlannedPass(Graph, Plan.Passes[Index], int32(Index));
	}
	for (const int32 Texture : Plan.Extracted)
	{
		Graph.Extract(GetName(Texture));
	}
}

/** The bits of everything that leaves the graph. */
std::vector<uint32> RunPlan(const FGraphPlan& Plan)
{
	FGraphTest Graph;
	Build(Graph, Plan);
	Graph.Run();
	std::vector<uint32> Bits;
	for (int32 Texture = 0; Texture < Plan.NumTextures; ++Texture)
	{
		if (!Plan.External.count(Texture) && !Plan.Extracted.count(Texture))
		{
			continue;
		}
		for (int32 Mip = 0; Mip < 2; ++Mip)
		{
			for (int32 Texel = 0; Texel < (Mip == 0 ? 16 : 4); ++Texel)
			{
				const int32 Width = Mip == 0 ? 4 : 2;
				const float Value = Graph.Pixel(GetName(Texture), Texel % Width, Texel / Width, Mip);
				uint32 Word = 0;
				std::memcpy(&Word, &Value, sizeof(Word));
				Bits.push_back(Word);
			}
		}
	}
	return Bits;
}

constexpr uint32 NumGraphs = 300;

/** Every graph, in the mode, gives the bits of the default mode. */
void ExpectSameBits(const TCHAR* Variable, int32 Value)
{
	size_t NumCompared = 0;
	for (uint32 Seed = 0; Seed < NumGraphs; ++Seed)
	{
		const FGraphPlan Plan = MakePlan(Seed);
		const std::vector<uint32> Expected = RunPlan(Plan);
		const FScopedConsoleVariable Mode(Variable, Value);
		ASSERT_EQ(Expected, RunPlan(Plan)) << Variable << " " << Value << ", seed " << Seed;
		NumCompared += Expected.size();
	}
	EXPECT_GT(NumCompared, 10000u);
}

} // namespace

TEST(RandomGraph, ImmediateModeGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.ImmediateMode"), 1);
}
TEST(RandomGraph, NoCullingGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.CullPasses"), 0);
}
TEST(RandomGraph, NoTransientHeapGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.TransientAllocator"), 0);
}
TEST(RandomGraph, ExtendedLifetimesGiveTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.Debug.ExtendResourceLifetimes"), 1);
}
TEST(RandomGraph, ACacheOfPassesGivesTheSameBits)
{
	FReuseCache Cache;
	for (uint32 Seed = 0; Seed < NumGraphs; ++Seed)
	{
		const FGraphPlan Plan = MakePlan(Seed);
		const std::vector<uint32> Expected = RunPlan(Plan);
		const FScopedReuse Scope(&Cache);
		ASSERT_EQ(Expected, RunPlan(Plan)) << "seed " << Seed;
	}
}
TEST(RandomGraph, ClobberingWith1000GivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.ClobberResources"), 1);
}
TEST(RandomGraph, ClobberingWithNaNGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.ClobberResources"), 2);
}
TEST(RandomGraph, ClobberingWithInfinityGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.ClobberResources"), 3);
}
TEST(RandomGraph, AsyncEverywhereGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.AsyncCompute"), 2);
}
TEST(RandomGraph, NoAsyncGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.AsyncCompute"), 0);
}
TEST(RandomGraph, NoValidationGivesTheSameBits)
{
	ExpectSameBits(TEXT("r.RDG.Validation"), 0);
}

TEST(RandomGraph, ResourcesThatShareMemoryAreNeverAliveTogether)
{
	size_t NumSharing = 0;
	for (uint32 Seed = 0; Seed < NumGraphs; ++Seed)
	{
		FGraphTest Graph;
		Build(Graph, MakePlan(Seed));
		const std::vector<FRDGCompiledResource> Resources = Graph.Builder->Compile().Resources;
		for (size_t A = 0; A < Resources.size(); ++A)
		{
			for (size_t B = A + 1; B < Resources.size(); ++B)
			{
				const FRDGCompiledResource& X = Resources[A];
				const FRDGCompiledResource& Y = Resources[B];
				if (!X.bTransient || !Y.bTransient || X.HeapOffset >= Y.HeapOffset + int64(Y.Bytes) ||
					Y.HeapOffset >= X.HeapOffset + int64(X.Bytes))
				{
					continue;
				}
				++NumSharing;
				EXPECT_TRUE(X.LastPass < Y.FirstPass || Y.LastPass < X.FirstPass)
					<< "seed " << Seed << ": " << X.Name << " and " << Y.Name;
			}
		}
	}
	EXPECT_GT(NumSharing, 50u);
}

TEST(RandomGraph, TheProducersOfASurvivorSurvive)
{
	size_t NumCulled = 0;
	for (uint32 Seed = 0; Seed < NumGraphs; ++Seed)
	{
		FGraphTest Graph;
		Build(Graph, MakePlan(Seed));
		const FRDGCompiledGraph Compiled = Graph.Builder->Compile();
		for (const FRDGCompiledPass& Pass : Compiled.Passes)
		{
			NumCulled += Pass.bCulled;
			EXPECT_EQ(Pass.bCulled, !Compiled.DescribeCulled(Pass).empty());
			for (const int32 Producer : Pass.Producers)
			{
				EXPECT_LT(Producer, Pass.Index);
				EXPECT_FALSE(!Pass.bCulled && Compiled.Passes[size_t(Producer)].bCulled)
					<< "seed " << Seed << ": " << Pass.Name;
			}
		}
	}
	EXPECT_GT(NumCulled, 100u);
}

TEST(RandomGraph, EveryLifetimeHoldsEveryUse)
{
	for (uint32 Seed = 0; Seed < NumGraphs; ++Seed)
	{
		FGraphTest Graph;
		Build(Graph, MakePlan(Seed));
		const FRDGCompiledGraph Compiled = Graph.Builder->Compile();
		for (const FRDGCompiledPass& Pass : Compiled.Passes)
		{
			for (const FRDGUse& Use : Pass.Uses)
			{
				const FRDGCompiledResource& Resource = Compiled.Resources[size_t(Use.Resource)];
				EXPECT_TRUE(Pass.bCulled || (Resource.FirstPass <= Pass.Index && Pass.Index <= Resource.LastPass))
					<< "seed " << Seed;
			}
		}
	}
}
