// Hand-made graph descriptions for the tests of single phases: no builder, no memory, no shaders.
//
//     FDescribedGraph Graph;
//     Graph.Pass("A", {Write("X")});
//     Graph.Pass("B", {Read("X"), Write("Y")});
//     Graph.Resource("Y").bExtracted = true;
//     const FRDGCullResult Result = CullPasses(Graph.Get(), ...);
#pragma once

#include <map>
#include <string>
#include <vector>

#include "RenderGraphCompiled.h"

namespace Drydock
{

struct FDescribedUse
{
	std::string Resource;
	ERHIAccess Access;
	int32_t FirstMip = 0;
	int32_t NumMips = -1; // -1: all
	int32_t SkipBarrierView = -1;
};

inline FDescribedUse Read(const std::string& Resource)
{
	return {Resource, ERHIAccess::SRVCompute};
}
inline FDescribedUse Write(const std::string& Resource)
{
	return {Resource, ERHIAccess::UAVCompute};
}
inline FDescribedUse ReadMip(const std::string& Resource, int32_t Mip)
{
	return {Resource, ERHIAccess::SRVCompute, Mip, 1};
}
inline FDescribedUse WriteMip(const std::string& Resource, int32_t Mip)
{
	return {Resource, ERHIAccess::UAVCompute, Mip, 1};
}
inline FDescribedUse Render(const std::string& Resource)
{
	return {Resource, ERHIAccess::RTV};
}

class FDescribedGraph
{
public:
	FDescribedGraph()
	{
		FRDGPassDescription& Prologue = Graph.Passes.emplace_back();
		Prologue.Index = 0;
		Prologue.Name = "Graph Prologue";
		Prologue.bIsSentinel = true;
	}

	/** The resource of that name: a 4x4 texture fit for every use, created where it is first named. */
	FRDGResourceDescription& Resource(const std::string& Name)
	{
		const auto [Found, bNew] = Indices.insert({Name, int32_t(Graph.Resources.size())});
		if (bNew)
		{
			FRDGResourceDescription& Resource = Graph.Resources.emplace_back();
			Resource.Name = Name;
			Resource.Format = PF_R32_FLOAT;
			Resource.Extent = FIntVector(4, 4, 1);
			Resource.Bytes = 256;
			Resource.bMayBeTransient = true;
			Resource.TextureFlags = TexCreate_ShaderResource | TexCreate_UAV | TexCreate_RenderTargetable;
		}
		return Graph.Resources[size_t(Found->second)];
	}

	int32_t GetIndex(const std::string& Name)
	{
		Resource(Name);
		return Indices.at(Name);
	}

	FRDGPassDescription& Pass(
		const std::string& Name, const std::vector<FDescribedUse>& Uses, ERDGPassFlags Flags = ERDGPassFlags::Compute)
	{
		std::vector<FRDGUse> PassUses;
		for (const FDescribedUse& Described : Uses)
		{
			const FRDGResourceDescription& Target = Resource(Described.Resource);
			FRDGUse& Use = PassUses.emplace_back();
			static_cast<FRDGSubresources&>(Use) = Target.GetWhole();
			Use.FirstMip = Described.FirstMip;
			Use.NumMips = Described.NumMips < 0 ? Target.NumMips : Described.NumMips;
			Use.Resource = Indices.at(Described.Resource);
			Use.Access = Described.Access;
			Use.Parameter = Described.Resource + "Parameter";
			Use.SkipBarrierView = Described.SkipBarrierView;
		}
		FRDGPassDescription& Pass = Graph.Passes.emplace_back();
		Pass.Index = int32_t(Graph.Passes.size()) - 1;
		Pass.Name = Name;
		Pass.Flags = Flags;
		Pass.File = "Test.cpp";
		Pass.Line = 100 + Pass.Index;
		Pass.bHasParameters = true;
		Pass.bAsync = EnumHasAnyFlags(Flags, ERDGPassFlags::AsyncCompute);
		Pass.Uses = PassUses;
		return Pass;
	}

	/** A raster pass with one colour target. */
	FRDGPassDescription& RasterPass(const std::string& Name, const std::string& Target,
		ERenderTargetLoadAction Load = ERenderTargetLoadAction::ELoad, std::vector<FDescribedUse> Uses = {})
	{
		Uses.push_back(Render(Target));
		FRDGPassDescription& Raster = Pass(Name, Uses, ERDGPassFlags::Raster);
		Raster.bHasTargetSlots = true;
		FRDGTarget& Color = Raster.Targets.Colors.emplace_back();
		Color.Resource = GetIndex(Target);
		Color.Load = Load;
		Raster.Uses.back().bLoads = Load == ERenderTargetLoadAction::ELoad;
		return Raster;
	}

	/** The description with its epilogue. */
	FRDGGraphDescription Get() const
	{
		FRDGGraphDescription Result = Graph;
		FRDGPassDescription& Epilogue = Result.Passes.emplace_back();
		Epilogue.Index = int32_t(Result.Passes.size()) - 1;
		Epilogue.Name = "Graph Epilogue";
		Epilogue.bIsSentinel = true;
		return Result;
	}

	/** Nothing culled. */
	std::vector<bool> KeepAll() const { return std::vector<bool>(Graph.Passes.size() + 1, false); }

private:
	FRDGGraphDescription Graph;
	std::map<std::string, int32_t> Indices;
};

} // namespace Drydock
