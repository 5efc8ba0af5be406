// Makes the RHI views behind a graph's views, and checks who touches a resource when.
#include "RenderGraphResources.h"

#include "RenderGraphConsoleVariables.h"
#include "RenderGraphReport.h"

FRDGResource::~FRDGResource() = default;

void FRDGResource::ValidateRHIAccess() const
{
	bUsed = true;
	if (!bAllowRHIAccess && Drydock::GetRDGSettings().bValidation)
	{
		Drydock::ThrowRDGError(Drydock::RDGErrorUndeclaredAccess,
			"accessing the RHI resource at this time is not allowed: only inside a pass whose parameters declare it",
			std::string("resource ") + Name);
	}
}

FRDGTextureSubresourceRange FRDGTextureSRV::GetSubresourceRange() const
{
	FRDGTextureSubresourceRange Range = Desc.Texture->GetSubresourceRangeSRV();
	Range.MipIndex = Desc.MipLevel;
	Range.NumMips = Desc.NumMipLevels ? Desc.NumMipLevels : Range.NumMips - Desc.MipLevel;
	if (Desc.NumArraySlices)
	{
		Range.ArraySlice = Desc.FirstArraySlice;
		Range.NumArraySlices = Desc.NumArraySlices;
	}
	Range.PlaneSlice = Desc.Format == PF_X24_G8 ? 1 : 0;
	return Range;
}

FRDGTextureSubresourceRange FRDGTextureUAV::GetSubresourceRange() const
{
	FRDGTextureSubresourceRange Range = Desc.Texture->GetSubresourceRangeSRV();
	Range.MipIndex = Desc.MipLevel;
	Range.NumMips = 1;
	if (Desc.NumArraySlices)
	{
		Range.ArraySlice = Desc.FirstArraySlice;
		Range.NumArraySlices = Desc.NumArraySlices;
	}
	return Range;
}

FRHIResource* FRDGView::GetParentRHI(const FRDGResource& Parent)
{
	return Parent.ResourceRHI.GetReference();
}

TRefCountPtr<FRHIResource> FRDGTextureSRV::CreateRHI() const
{
	return new FRHIShaderResourceView(static_cast<FRHITexture*>(GetParentRHI(*Desc.Texture)), Desc);
}

TRefCountPtr<FRHIResource> FRDGTextureUAV::CreateRHI() const
{
	return new FRHIUnorderedAccessView(static_cast<FRHITexture*>(GetParentRHI(*Desc.Texture)), Desc);
}

TRefCountPtr<FRHIResource> FRDGBufferSRV::CreateRHI() const
{
	return new FRHIShaderResourceView(static_cast<FRHIBuffer*>(GetParentRHI(*Desc.Buffer)), Desc);
}

TRefCountPtr<FRHIResource> FRDGBufferUAV::CreateRHI() const
{
	return new FRHIUnorderedAccessView(static_cast<FRHIBuffer*>(GetParentRHI(*Desc.Buffer)), Desc);
}
