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

FRDGTextureSRVDesc FRDGTextureSRVDesc::CreateForMetaData(FRDGTextureRef Texture, ERDGTextureMetaDataAccess MetaData)
{
	checkf(MetaData <= ERDGTextureMetaDataAccess::Stencil,
		"%s has no such plane: only graphics memory keeps HTile, FMask and CMask", Texture ? Texture->Name : "(null)");
	return MetaData == ERDGTextureMetaDataAccess::Stencil ? CreateWithPixelFormat(Texture, PF_X24_G8)
														  : FRDGTextureSRVDesc(Texture);
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
