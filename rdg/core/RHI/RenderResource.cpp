// Render resources and the plain textures. Source: engine RenderResource.cpp, RenderUtils.cpp for behaviour.
#include "RenderResource.h"

#include "CodeScope.h"
#include "PipelineStateCache.h"

#include <mutex>
#include <vector>

constinit const Drydock::FPlainTexture GWhiteTexture(TEXT("WhiteTexture"), 0xffffffff);
constinit const Drydock::FPlainTexture GBlackTexture(TEXT("BlackTexture"), 0xff000000);
constinit const Drydock::FPlainTexture GTransparentBlackTexture(TEXT("TransparentBlackTexture"), 0x00000000);

FRenderResource::~FRenderResource() = default;

void FRenderResource::InitResource(FRHICommandListBase& RHICmdList)
{
	if (!bInitialized)
	{
		bInitialized = true;
		InitRHI(RHICmdList);
	}
}

void FRenderResource::ReleaseResource()
{
	if (bInitialized)
	{
		bInitialized = false;
		ReleaseRHI();
	}
}

namespace Drydock
{

namespace
{

struct FGlobalResource
{
	FRenderResource* Resource;
	FCodeOwner Owner;
	bool bMade = false;
};

struct FGlobalResources
{
	std::mutex Mutex;
	std::vector<FGlobalResource> Resources;

	static FGlobalResources& Get()
	{
		static FGlobalResources* const Registry = new FGlobalResources; // outlives resources of any shared object
		return *Registry;
	}
};

} // namespace

void AddGlobalResource(FRenderResource& Resource)
{
	FGlobalResources& Registry = FGlobalResources::Get();
	const std::lock_guard Lock(Registry.Mutex);
	Registry.Resources.push_back({&Resource, MakeCodeOwner("InitRHI of a global resource")});
}

void RemoveGlobalResource(FRenderResource& Resource)
{
	FGlobalResources& Registry = FGlobalResources::Get();
	const std::lock_guard Lock(Registry.Mutex);
	std::erase_if(
		Registry.Resources, [&Resource](const FGlobalResource& Known) { return Known.Resource == &Resource; });
}

void InitGlobalResources()
{
	FGlobalResources& Registry = FGlobalResources::Get();
	std::vector<FGlobalResource> ToMake;
	{
		const std::lock_guard Lock(Registry.Mutex);
		for (FGlobalResource& Known : Registry.Resources)
		{
			if (!Known.bMade)
			{
				ToMake.push_back(Known);
				Known.bMade = true;
			}
		}
	}
	for (const FGlobalResource& Made : ToMake)
	{
		CallCode(Made.Owner, [&] { Made.Resource->InitResource(); });
	}
}

FTextureWithSRV* FPlainTexture::Get() const
{
	if (!Texture)
	{
		Texture = new FTextureWithSRV;
		Texture->TextureRHI = RHICreateTexture(
			FRHITextureCreateDesc::Create2D(Name, 1, 1, PF_B8G8R8A8).SetFlags(ETextureCreateFlags::ShaderResource));
		const FLinearColor Value(float((Color >> 16) & 0xff) / 255.0f, float((Color >> 8) & 0xff) / 255.0f,
			float(Color & 0xff) / 255.0f, float(Color >> 24) / 255.0f);
		Texture->TextureRHI->Fill(Value);
		Texture->SamplerStateRHI = TStaticSamplerState<SF_Bilinear, AM_Wrap, AM_Wrap, AM_Wrap>::GetRHI();
		Texture->ShaderResourceViewRHI = RHICreateShaderResourceView(Texture->TextureRHI, 0);
		Texture->InitResource();
	}
	return Texture;
}

} // namespace Drydock

FRHIVertexDeclaration* PipelineStateCache::GetOrCreateVertexDeclaration(const FVertexDeclarationElementList& Elements)
{
	static TArray<FVertexDeclarationRHIRef> Declarations;
	Declarations.Add(RHICreateVertexDeclaration(Elements));
	return Declarations.Last();
}
