// Runs a pass's lambda, inside a render pass over its targets where it is a raster pass.
#include "RenderGraphExecute.h"

#include "RenderGraphFeedback.h"
#include "ShaderParameterMacros.h"

namespace Drydock
{

void FRDGExecutor::RunLambda(FRDGPass& Pass, const FRDGPassResources& Resources)
{
	const bool bRenderPass = Resources.TargetSlots && EnumHasAnyFlags(Pass.GetFlags(), ERDGPassFlags::Raster) &&
							 !EnumHasAnyFlags(Pass.GetFlags(), ERDGPassFlags::SkipRenderPass) &&
							 !Describe(Pass).Targets.IsEmpty();
	if (!bRenderPass)
	{
		Pass.Execute(RHICmdList);
		return;
	}
	struct FRenderPassScope
	{
		FRenderPassScope(FRHICommandListImmediate& InList, const FRHIRenderPassInfo& Info, const TCHAR* Name)
			: List(InList)
		{
			List.BeginRenderPass(Info, Name);
		}
		// Also when the lambda throws: the list outlives the graph.
		~FRenderPassScope() { List.EndRenderPass(); }

		FRHICommandListImmediate& List;
	};
	const auto GetTexture = [this](int32 Resource)
	{
		return static_cast<FRHITexture*>(State.Resources[size_t(Resource)]->ResourceRHI.GetReference());
	};
	FRHIRenderPassInfo Info = MakeRenderPassInfo(*Resources.TargetSlots);
	FRDGFeedbackTargets Feedback(Describe(Pass), GetTexture, Info);
	{
		const FRenderPassScope RenderPass(RHICmdList, Info, Pass.GetName());
		Pass.Execute(RHICmdList);
	}
	Feedback.PutBack(RHICmdList);
}

FRHIRenderPassInfo FRDGExecutor::MakeRenderPassInfo(const FRenderTargetBindingSlots& Slots) const
{
	const auto GetTexture = [](const FRDGTexture* Texture)
	{
		return Texture ? static_cast<FRHITexture*>(Texture->ResourceRHI.GetReference()) : nullptr;
	};

	FRHIRenderPassInfo Info;
	int32 Count = 0;
	Slots.Enumerate(
		[&](const FRenderTargetBinding& Binding)
		{
			const bool bResolve = Binding.GetResolveTexture() && Binding.GetResolveTexture() != Binding.GetTexture();
			FRHIRenderPassInfo::FColorEntry& Entry = Info.ColorRenderTargets[Count++];
			Entry.RenderTarget = GetTexture(Binding.GetTexture());
			Entry.ResolveTarget = bResolve ? GetTexture(Binding.GetResolveTexture()) : nullptr;
			Entry.ArraySlice = Binding.GetArraySlice();
			Entry.MipIndex = Binding.GetMipIndex();
			Entry.Action = MakeRenderTargetActions(Binding.GetLoadAction(),
				bResolve ? ERenderTargetStoreAction::EMultisampleResolve : ERenderTargetStoreAction::EStore);
			Binding.GetTexture()->MarkResourceAsUsed();
		});
	if (const FRDGTexture* Depth = Slots.DepthStencil.GetTexture())
	{
		const auto MakeActions = [](ERenderTargetLoadAction Load)
		{
			return MakeRenderTargetActions(Load, ERenderTargetStoreAction::EStore);
		};
		Info.DepthStencilRenderTarget.DepthStencilTarget = GetTexture(Depth);
		Info.DepthStencilRenderTarget.Action =
			MakeDepthStencilTargetActions(MakeActions(Slots.DepthStencil.GetDepthLoadAction()),
				MakeActions(Slots.DepthStencil.GetStencilLoadAction()));
		Info.DepthStencilRenderTarget.ExclusiveDepthStencil = Slots.DepthStencil.GetDepthStencilAccess();
		Depth->MarkResourceAsUsed();
	}
	return Info;
}

} // namespace Drydock
