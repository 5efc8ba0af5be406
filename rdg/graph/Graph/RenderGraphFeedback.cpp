// Finds targets that their pass reads, and swaps them for copies.
#include "RenderGraphFeedback.h"

#include <algorithm>

namespace Drydock
{

bool IsFeedback(const FRDGUse& A, const FRDGUse& B)
{
	const auto IsReadOf = [](const FRDGUse& Read, const FRDGUse& Target)
	{
		return Target.Access == ERHIAccess::RTV && EnumHasAnyFlags(Read.Access, ERHIAccess::SRVMask) && !Read.IsWrite();
	};
	return A.Resource == B.Resource && A.Overlaps(B) && (IsReadOf(A, B) || IsReadOf(B, A));
}

FRDGFeedbackTargets::FRDGFeedbackTargets(
	const FRDGPassDescription& Pass, TFunctionRef<FRHITexture*(int32)> GetTexture, FRHIRenderPassInfo& Info)
{
	for (const FRDGUse& Use : Pass.Uses)
	{
		const bool bRead = std::ranges::any_of(
			Pass.Uses, [&](const FRDGUse& Other) { return Use.Access == ERHIAccess::RTV && IsFeedback(Use, Other); });
		if (bRead)
		{
			Redirect(GetTexture(Use.Resource), Info);
		}
	}
}

void FRDGFeedbackTargets::Redirect(FRHITexture* Texture, FRHIRenderPassInfo& Info)
{
	const bool bKnown = std::ranges::any_of(Targets, [&](const FTarget& Target) { return Target.Texture == Texture; });
	if (bKnown)
	{
		return;
	}
	Targets.push_back({Texture, Texture->Clone()});
	for (FRHIRenderPassInfo::FColorEntry& Entry : Info.ColorRenderTargets)
	{
		Entry.RenderTarget = Entry.RenderTarget == Texture ? Targets.back().Copy.GetReference() : Entry.RenderTarget;
	}
}

void FRDGFeedbackTargets::PutBack(FRHICommandListImmediate& RHICmdList)
{
	for (const FTarget& Target : Targets)
	{
		Target.Texture->CopyFrom(*Target.Copy);
		RHICmdList.CountAs(Target.Copy, Target.Texture);
	}
}

} // namespace Drydock
