// Walks a pass's parameter struct, and the uniform buffers in it, for what the pass touches.
#include "RenderGraphParameter.h"

#include "RenderGraphReport.h"
#include "RenderGraphResources.h"
#include "RenderGraphValidate.h"
#include "ShaderParameterMacros.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

FRDGSubresources ToBox(const FRDGTextureSubresourceRange& Range)
{
	return {int32(Range.MipIndex), int32(Range.NumMips), int32(Range.ArraySlice), int32(Range.NumArraySlices),
		int32(Range.PlaneSlice), int32(Range.NumPlaneSlices)};
}

ERHIAccess GetReadAccess(ERDGPassFlags Flags)
{
	ERHIAccess Access = ERHIAccess::Unknown;
	Access |= EnumHasAnyFlags(Flags, ERDGPassFlags::Raster) ? ERHIAccess::SRVGraphics : ERHIAccess::Unknown;
	Access |= EnumHasAnyFlags(Flags, ERDGPassFlags::Compute | ERDGPassFlags::AsyncCompute) ? ERHIAccess::SRVCompute
																						   : ERHIAccess::Unknown;
	Access |= EnumHasAnyFlags(Flags, ERDGPassFlags::Copy) ? ERHIAccess::CopySrc : ERHIAccess::Unknown;
	return Access == ERHIAccess::Unknown ? ERHIAccess::SRVMask : Access;
}

ERHIAccess GetWriteAccess(ERDGPassFlags Flags)
{
	return EnumHasAnyFlags(Flags, ERDGPassFlags::Raster) ? ERHIAccess::UAVGraphics : ERHIAccess::UAVCompute;
}

class FCollector
{
public:
	FCollector(TFunctionRef<bool(const void*, ERDGObject)> InIsKnown, FRDGPassDescription& InPass)
		: IsKnown(InIsKnown)
		, Pass(InPass)
	{
	}

	FRDGPassResources Run(const FShaderParametersMetadata& Metadata, const void* Parameters)
	{
		constexpr size_t NumUsual = 4; // enough for most passes
		Pass.Uses.reserve(NumUsual);
		Found.Viewables.reserve(NumUsual);
		Walk(Metadata, Parameters, "");
		for (const FPending& Pending : UniformBuffers)
		{
			// A uniform buffer's textures are all made readable, except what the pass itself writes.
			bInUniformBuffer = true;
			Variable = std::string(Pending.Buffer->GetMetadata().GetShaderVariableName()) + "_";
			Walk(Pending.Buffer->GetMetadata(), Pending.Buffer->GetContents(), Pending.Name + "->");
		}
		return std::move(Found);
	}

private:
	struct FPending
	{
		FRDGUniformBuffer* Buffer;
		std::string Name;
	};

	/** The pointer in a member. An unknown one is thrown: looking into it would touch memory that may be gone. */
	template<typename T>
	T* Read(const void* Contents, const FHlslMember& Member, const std::string& Name)
	{
		T* Pointer = nullptr;
		std::memcpy(&Pointer, static_cast<const uint8*>(Contents) + Member.Offset, sizeof(Pointer));
		return CheckKnown(Pointer, Name);
	}

	template<typename T>
	T* CheckKnown(T* Pointer, const std::string& Name)
	{
		if (Pointer && !IsKnown(Pointer, GetKinds(Pointer)))
		{
			const FDiagnostic Diagnostic = MakePassDiagnostic(ESeverity::Error, RDGErrorForeignResource, Pass,
				"the parameter points to something that is not a resource of this graph (left from another graph, or "
				"deleted)",
				Name);
			ThrowRDGErrors({Diagnostic});
		}
		return Pointer;
	}

	void AddUse(FRDGViewableResource* Resource, const FRDGSubresources& Box, ERHIAccess Access, const std::string& Name,
		bool bLoads = false, int32 SkipBarrierView = -1)
	{
		const int32 Index = Resource->GetIndex();
		if (bInUniformBuffer && std::ranges::any_of(Pass.Uses,
									[Index](const FRDGUse& Use) { return Use.Resource == Index && Use.IsWrite(); }))
		{
			return;
		}
		FRDGUse& Use = Pass.Uses.emplace_back();
		static_cast<FRDGSubresources&>(Use) = Box;
		Use.Resource = Index;
		Use.Access = Access;
		Use.Parameter = Name;
		Use.bLoads = bLoads;
		Use.SkipBarrierView = SkipBarrierView;
		const bool bNew = std::ranges::find(Found.Viewables, Resource) == Found.Viewables.end();
		const auto IsResource = [Resource](const FRDGUniformBufferResource& Known)
		{
			return Known.Resource == Resource;
		};
		if (bInUniformBuffer && (bNew || std::ranges::any_of(Found.InUniformBuffers, IsResource)))
		{
			Found.InUniformBuffers.push_back({Resource, Variable + Walked->Name});
		}
		if (bNew)
		{
			Found.Viewables.push_back(Resource);
		}
	}

	static FRDGSubresources GetWhole(FRDGViewableResource* Resource)
	{
		return Resource->Type == ERDGViewableResourceType::Texture
				   ? ToBox(static_cast<FRDGTexture*>(Resource)->GetSubresourceRange())
				   : FRDGSubresources();
	}

	void AddView(FRDGView* View, const FRDGSubresources& Box, ERHIAccess Access, const std::string& Name,
		int32 SkipBarrierView = -1)
	{
		Found.Views.push_back(View);
		AddUse(View->GetParent(), Box, Access, Name, false, SkipBarrierView);
	}

	void AddTextureAccess(const FRDGTextureAccess& Access, const std::string& Name)
	{
		FRDGTexture* Texture = CheckKnown(Access.GetTexture(), Name);
		if (Texture && Access.GetAccess() != ERHIAccess::Unknown)
		{
			AddUse(Texture, GetWhole(Texture), Access.GetAccess(), Name);
		}
	}

	void AddBufferAccess(const FRDGBufferAccess& Access, const std::string& Name)
	{
		FRDGBuffer* Buffer = CheckKnown(Access.GetBuffer(), Name);
		if (Buffer && Access.GetAccess() != ERHIAccess::Unknown)
		{
			AddUse(Buffer, GetWhole(Buffer), Access.GetAccess(), Name);
		}
	}

	void AddTextureAccesses(const FRDGTextureAccessArray& Accesses, const std::string& Name)
	{
		for (const FRDGTextureAccess& Access : Accesses)
		{
			AddTextureAccess(Access, Name);
		}
	}

	void AddBufferAccesses(const FRDGBufferAccessArray& Accesses, const std::string& Name)
	{
		for (const FRDGBufferAccess& Access : Accesses)
		{
			AddBufferAccess(Access, Name);
		}
	}

	/** A pointer to a view that the graph does not know of: what it changes lies outside. */
	void AddExternalOutput(const uint8* Address)
	{
		const void* View = nullptr;
		std::memcpy(&View, Address, sizeof(View));
		Pass.bHasExternalOutputs = Pass.bHasExternalOutputs || View;
	}

	/** Views made with SkipBarrier are told apart by their place among the graph's objects: any number unique to the
	 * view. */
	static int32 GetSkipBarrierView(const FRDGUnorderedAccessView* View)
	{
		return EnumHasAnyFlags(View->Flags, ERDGUnorderedAccessViewFlags::SkipBarrier) ? View->GetViewIndex() : -1;
	}

	void Walk(const FShaderParametersMetadata& Metadata, const void* Contents, const std::string& Prefix)
	{
		for (const FHlslMember& Member : Metadata.GetHlslMembers())
		{
			if (Member.IsConstant())
			{
				continue;
			}
			Walked = &Member;
			if (Prefix.empty())
			{
				WalkMember(Member, Contents, Member.CodeName);
			}
			else
			{
				WalkMember(Member, Contents, Prefix + Member.CodeName);
			}
		}
	}

	void WalkMember(const FHlslMember& Member, const void* Contents, const std::string& Name)
	{
		const auto* Address = static_cast<const uint8*>(Contents) + Member.Offset;
		switch (Member.BaseType)
		{
		case UBMT_RDG_TEXTURE:
			if (FRDGTexture* Texture = Read<FRDGTexture>(Contents, Member, Name))
			{
				AddUse(Texture, ToBox(Texture->GetSubresourceRangeSRV()), GetReadAccess(Pass.Flags), Name);
			}
			break;
		case UBMT_RDG_TEXTURE_SRV:
			if (FRDGTextureSRV* View = Read<FRDGTextureSRV>(Contents, Member, Name))
			{
				AddView(View, ToBox(View->GetSubresourceRange()), GetReadAccess(Pass.Flags), Name);
			}
			break;
		case UBMT_RDG_TEXTURE_UAV:
			if (FRDGTextureUAV* View = Read<FRDGTextureUAV>(Contents, Member, Name))
			{
				AddView(View, ToBox(View->GetSubresourceRange()), GetWriteAccess(Pass.Flags), Name,
					GetSkipBarrierView(View));
			}
			else
			{
				Pass.UnsetOutputs.push_back(Name);
			}
			break;
		case UBMT_RDG_BUFFER_SRV:
			if (FRDGBufferSRV* View = Read<FRDGBufferSRV>(Contents, Member, Name))
			{
				AddView(View, FRDGSubresources(), GetReadAccess(Pass.Flags), Name);
			}
			break;
		case UBMT_RDG_BUFFER_UAV:
			if (FRDGBufferUAV* View = Read<FRDGBufferUAV>(Contents, Member, Name))
			{
				AddView(View, FRDGSubresources(), GetWriteAccess(Pass.Flags), Name, GetSkipBarrierView(View));
			}
			else
			{
				Pass.UnsetOutputs.push_back(Name);
			}
			break;
		case UBMT_RDG_TEXTURE_ACCESS:
			AddTextureAccess(*reinterpret_cast<const FRDGTextureAccess*>(Address), Name);
			break;
		case UBMT_RDG_BUFFER_ACCESS:
			AddBufferAccess(*reinterpret_cast<const FRDGBufferAccess*>(Address), Name);
			break;
		case UBMT_RDG_TEXTURE_ACCESS_ARRAY:
			AddTextureAccesses(*reinterpret_cast<const FRDGTextureAccessArray*>(Address), Name);
			break;
		case UBMT_RDG_BUFFER_ACCESS_ARRAY:
			AddBufferAccesses(*reinterpret_cast<const FRDGBufferAccessArray*>(Address), Name);
			break;
		case UBMT_RDG_UNIFORM_BUFFER:
			if (FRDGUniformBuffer* Buffer = Read<FRDGUniformBuffer>(Contents, Member, Name))
			{
				Found.UniformBuffers.push_back(Buffer);
				UniformBuffers.push_back({Buffer, Name});
			}
			break;
		case UBMT_UAV:
			AddExternalOutput(Address);
			break;
		case UBMT_RENDER_TARGET_BINDING_SLOTS:
			Pass.bHasTargetSlots = true;
			Found.TargetSlots = reinterpret_cast<const FRenderTargetBindingSlots*>(Address);
			AddTargets(*Found.TargetSlots, Name);
			break;
		default:
			break;
		}
	}

	void AddTargets(const FRenderTargetBindingSlots& Slots, const std::string& Name)
	{
		int32 NumSlots = MaxSimultaneousRenderTargets;
		while (NumSlots > 0 && !Slots[NumSlots - 1].GetTexture() && !Slots[NumSlots - 1].GetResolveTexture())
		{
			--NumSlots;
		}
		if (NumSlots == 0 && !Slots.DepthStencil.GetTexture())
		{
			Pass.UnsetOutputs.push_back(Name + "[0]");
		}
		Pass.Targets.Colors.reserve(size_t(NumSlots));
		for (int32 Slot = 0; Slot < NumSlots; ++Slot)
		{
			AddColorTarget(Slots[Slot], Name + "[" + std::to_string(Slot) + "]");
		}
		if (Slots.DepthStencil.GetTexture())
		{
			AddDepthStencilTarget(Slots.DepthStencil, Name + ".DepthStencil");
		}
		Pass.Targets.NumOcclusionQueries = int32(Slots.NumOcclusionQueries);
		Pass.Targets.ResolveRect =
			FIntRect(Slots.ResolveRect.X1, Slots.ResolveRect.Y1, Slots.ResolveRect.X2, Slots.ResolveRect.Y2);
		if (Slots.ShadingRateTexture)
		{
			FRDGTexture* const Texture = CheckKnown(Slots.ShadingRateTexture, Name + ".ShadingRateTexture");
			Pass.Targets.ShadingRate = Texture->GetIndex();
			AddUse(Texture, GetWhole(Texture), ERHIAccess::ShadingRateSource, Name + ".ShadingRateTexture");
		}
	}

	void AddColorTarget(const FRenderTargetBinding& Binding, const std::string& Name)
	{
		FRDGTarget& Target = Pass.Targets.Colors.emplace_back();
		Target.Mip = Binding.GetMipIndex();
		Target.Slice = Binding.GetArraySlice();
		Target.Load = Binding.GetLoadAction();
		if (FRDGTexture* Texture = CheckKnown(Binding.GetTexture(), Name))
		{
			Target.Resource = Texture->GetIndex();
			FRDGSubresources Box = GetWhole(Texture);
			Box.FirstMip = Target.Mip;
			Box.NumMips = 1;
			if (Target.Slice >= 0)
			{
				Box.Slice = Target.Slice;
				Box.NumSlices = 1;
			}
			CheckTargetRange(Box, Texture, Name);
			AddUse(Texture, Box, ERHIAccess::RTV, Name, Target.Load == ERenderTargetLoadAction::ELoad);
		}
		if (FRDGTexture* Resolve = CheckKnown(Binding.GetResolveTexture(), Name))
		{
			Target.ResolveResource = Resolve->GetIndex();
			if (Resolve != Binding.GetTexture())
			{
				AddUse(Resolve, FRDGSubresources(), ERHIAccess::RTV | ERHIAccess::ResolveDst, Name + ".Resolve");
			}
		}
	}

	/** A mip or slice that is not there would be written outside the texture. */
	void CheckTargetRange(const FRDGSubresources& Box, FRDGTexture* Texture, const std::string& Name)
	{
		const FRDGSubresources Whole = GetWhole(Texture);
		if (Box.FirstMip >= Whole.NumMips || Box.Slice >= Whole.NumSlices)
		{
			const FDiagnostic Diagnostic = MakePassDiagnostic(ESeverity::Error, RDGErrorRenderTargets, Pass,
				"the render target names mip " + std::to_string(Box.FirstMip) + ", slice " + std::to_string(Box.Slice) +
					" of a texture with " + std::to_string(Whole.NumMips) + " mips and " +
					std::to_string(Whole.NumSlices) + " slices",
				Name, Texture->Name);
			ThrowRDGErrors({Diagnostic});
		}
	}

	void AddDepthStencilTarget(const FDepthStencilBinding& Binding, const std::string& Name)
	{
		FRDGTexture* const Texture = CheckKnown(Binding.GetTexture(), Name);
		const FExclusiveDepthStencil Access = Binding.GetDepthStencilAccess();
		Pass.Targets.DepthStencil = Texture->GetIndex();
		Pass.Targets.DepthLoad = Binding.GetDepthLoadAction();
		Pass.Targets.StencilLoad = Binding.GetStencilLoadAction();
		Pass.Targets.DepthStencilAccess = Access.GetDepthStencil();
		FRDGSubresources Depth = GetWhole(Texture);
		Depth.NumPlanes = 1;
		if (Access.IsUsingDepth())
		{
			AddUse(Texture, Depth, Access.IsDepthWrite() ? ERHIAccess::DSVWrite : ERHIAccess::DSVRead, Name,
				Binding.GetDepthLoadAction() == ERenderTargetLoadAction::ELoad);
		}
		FRDGSubresources Stencil = Depth;
		Stencil.Plane = 1;
		if (Access.IsUsingStencil() && GetWhole(Texture).NumPlanes > 1)
		{
			AddUse(Texture, Stencil, Access.IsStencilWrite() ? ERHIAccess::DSVWrite : ERHIAccess::DSVRead,
				Name + " (stencil)", Binding.GetStencilLoadAction() == ERenderTargetLoadAction::ELoad);
		}
	}

	TFunctionRef<bool(const void*, ERDGObject)> IsKnown;
	FRDGPassDescription& Pass;
	FRDGPassResources Found;
	std::vector<FPending> UniformBuffers;
	bool bInUniformBuffer = false;
	std::string Variable; // of the uniform buffer that is walked, with its underscore
	const FHlslMember* Walked = nullptr;
};

} // namespace

FRDGPassResources CollectPassResources(const FShaderParametersMetadata& Metadata, const void* Parameters,
	TFunctionRef<bool(const void*, ERDGObject)> IsKnown, FRDGPassDescription& Pass)
{
	return FCollector(IsKnown, Pass).Run(Metadata, Parameters);
}

} // namespace Drydock
