// Textures, buffers, views and uniform buffers of a graph. They describe; memory comes when the graph is executed, and
// GetRHI is only for passes that declare the resource in their parameters. All are owned by their builder.
// Source: engine RenderGraphResources.h.
#pragma once

#include "RHIResources.h"
#include "RenderGraphDefinitions.h"
#include "RenderGraphTextureSubresource.h"
#include "RenderTargetPool.h"

class FShaderParametersMetadata;

/** Everything of a graph that has an RHI object in the end. */
class DRYDOCK_API FRDGResource
{
public:
	virtual ~FRDGResource();
	FRDGResource(const FRDGResource&) = delete;
	FRDGResource& operator=(const FRDGResource&) = delete;

	/** The RHI object. A check outside a pass that declares the resource. */
	FRHIResource* GetRHI() const
	{
		ValidateRHIAccess();
		return ResourceRHI.GetReference();
	}

	/** Memory has been assigned. */
	bool HasRHI() const { return ResourceRHI.IsValid(); }

	/** Tells the validation that a declared resource is meant although GetRHI is not called. */
	void MarkResourceAsUsed() const { bUsed = true; }

	/** Name for messages and dumps; the pointer given at creation is kept. */
	const TCHAR* const Name;

protected:
	explicit FRDGResource(const TCHAR* InName)
		: Name(InName)
	{
	}

	/** Marks the resource as used and checks that it may be touched now. */
	void ValidateRHIAccess() const;

	TRefCountPtr<FRHIResource> ResourceRHI;

private:
	friend class FRDGBuilder;
	friend class FRDGView;
	friend class Drydock::FRDGExecutor;

	bool bAllowRHIAccess = false; // a pass that declares it is running, or it is in external access mode
	mutable bool bUsed = false;
};

/** A texture or a buffer. */
class DRYDOCK_API FRDGViewableResource : public FRDGResource
{
public:
	const ERDGViewableResourceType Type;

	/** Registered from outside, or converted to external. */
	bool IsExternal() const { return bExternal; }
	bool IsExtracted() const { return bExtracted; }
	/** Lives in the graph's own heap and shares memory with others. Known once compiled. */
	bool IsTransient() const { return bTransient; }
	bool IsCulled() const { return bCulled; }
	/** Some pass added so far writes it, or its contents came from outside. */
	bool HasBeenProduced() const { return bProduced; }

	/** Position in FRDGCompiledGraph::Resources. */
	int32 GetIndex() const { return Index; }

protected:
	FRDGViewableResource(const TCHAR* InName, ERDGViewableResourceType InType, bool bInSkipTracking)
		: FRDGResource(InName)
		, Type(InType)
		, bSkipTracking(bInSkipTracking)
	{
	}

private:
	friend class FRDGBuilder;
	friend class Drydock::FRDGExecutor;

	int32 Index = -1;
	ERHIAccess AccessFinal = ERHIAccess::Unknown;    // Unknown: the user gave none
	ERHIAccess ExternalAccess = ERHIAccess::Unknown; // external access mode as declared so far
	bool bExternalAccessNow = false;                 // external access mode as executed so far
	bool bExternal = false;
	bool bRegistered = false; // external from the start
	bool bExtracted = false;
	bool bProduced = false;
	bool bQueuedForUpload = false;
	bool bForceNonTransient = false;
	bool bTransient = false;
	bool bCulled = false;
	bool bSkipTracking = false;
	bool bSkipUnusedWarning = false;
	bool bReady = false; // has memory, is clobbered or filled where it has to be
};

class DRYDOCK_API FRDGTexture final : public FRDGViewableResource
{
public:
	static constexpr ERDGViewableResourceType StaticType = ERDGViewableResourceType::Texture;

	const FRDGTextureDesc Desc;
	const ERDGTextureFlags Flags;

	FRHITexture* GetRHI() const { return static_cast<FRHITexture*>(FRDGResource::GetRHI()); }

	FRDGTextureSubresourceLayout GetSubresourceLayout() const { return Layout; }
	FRDGTextureSubresourceRange GetSubresourceRange() const { return FRDGTextureSubresourceRange(Layout); }
	/** Range of a shader-resource view of everything; of depth-stencil textures it covers the depth only. */
	FRDGTextureSubresourceRange GetSubresourceRangeSRV() const
	{
		FRDGTextureSubresourceRange Range(Layout);
		Range.NumPlaneSlices = 1;
		return Range;
	}
	uint32 GetSubresourceCount() const { return Layout.GetSubresourceCount(); }

private:
	friend class FRDGBuilder;
	friend class Drydock::FRDGExecutor;

	FRDGTexture(const TCHAR* InName, const FRDGTextureDesc& InDesc, ERDGTextureFlags InFlags)
		: FRDGViewableResource(InName, StaticType, EnumHasAnyFlags(InFlags, ERDGTextureFlags::SkipTracking))
		, Desc(InDesc)
		, Flags(InFlags)
		, Layout(InDesc)
	{
	}

	FRDGTextureSubresourceLayout Layout;
	TRefCountPtr<IPooledRenderTarget> PooledTexture; // external and extracted textures
};

class DRYDOCK_API FRDGBuffer final : public FRDGViewableResource
{
public:
	static constexpr ERDGViewableResourceType StaticType = ERDGViewableResourceType::Buffer;

	/** The element count of a buffer made with a callback is final once the graph is executed. */
	FRDGBufferDesc Desc;
	const ERDGBufferFlags Flags;

	FRHIBuffer* GetRHI() const { return static_cast<FRHIBuffer*>(FRDGResource::GetRHI()); }
	/** The same, for arguments of DispatchIndirect and DrawIndirect. */
	FRHIBuffer* GetIndirectRHICallBuffer() const { return GetRHI(); }
	uint32 GetSize() const { return Desc.GetSize(); }
	uint32 GetStride() const { return Desc.BytesPerElement; }

private:
	friend class FRDGBuilder;
	friend class Drydock::FRDGExecutor;

	FRDGBuffer(const TCHAR* InName, const FRDGBufferDesc& InDesc, ERDGBufferFlags InFlags)
		: FRDGViewableResource(InName, StaticType, EnumHasAnyFlags(InFlags, ERDGBufferFlags::SkipTracking))
		, Desc(InDesc)
		, Flags(InFlags)
	{
	}

	FRDGBufferNumElementsCallback NumElementsCallback;
	TRefCountPtr<FRDGPooledBuffer> PooledBuffer; // external and extracted buffers
};

// Views -------------------------------------------------------------------------------------------------------------

/** Mips and slices of a texture for reading. Zero counts: all from the first. */
class FRDGTextureSRVDesc final : public FRHITextureSRVCreateInfo
{
public:
	FRDGTextureSRVDesc() = default;
	FRDGTextureSRVDesc(FRDGTextureRef InTexture)
		: FRHITextureSRVCreateInfo(0, 0)
		, Texture(InTexture)
	{
	}

	static FRDGTextureSRVDesc Create(FRDGTextureRef Texture) { return FRDGTextureSRVDesc(Texture); }
	static FRDGTextureSRVDesc CreateForMipLevel(FRDGTextureRef Texture, int32 MipLevel)
	{
		FRDGTextureSRVDesc Desc(Texture);
		Desc.MipLevel = uint8(MipLevel);
		Desc.NumMipLevels = 1;
		return Desc;
	}
	static FRDGTextureSRVDesc CreateForSlice(FRDGTextureRef Texture, int32 SliceIndex)
	{
		FRDGTextureSRVDesc Desc(Texture);
		Desc.FirstArraySlice = uint16(SliceIndex);
		Desc.NumArraySlices = 1;
		return Desc;
	}
	/** One plane. CompressedSurface and Depth are the texture itself; Stencil needs a depth-stencil texture. A check
	 * for a plane that only graphics memory has (HTile, FMask, CMask). */
	static DRYDOCK_API FRDGTextureSRVDesc CreateForMetaData(FRDGTextureRef Texture, ERDGTextureMetaDataAccess MetaData);
	/** PF_X24_G8 views the stencil of a depth-stencil texture. */
	static FRDGTextureSRVDesc CreateWithPixelFormat(FRDGTextureRef Texture, EPixelFormat PixelFormat)
	{
		FRDGTextureSRVDesc Desc(Texture);
		Desc.Format = PixelFormat;
		return Desc;
	}

	bool IsValid() const { return Texture != nullptr; }

	FRDGTextureRef Texture = nullptr;
};

/** One mip of a texture for writing. */
class FRDGTextureUAVDesc final : public FRHITextureUAVCreateInfo
{
public:
	FRDGTextureUAVDesc() = default;
	FRDGTextureUAVDesc(FRDGTextureRef InTexture, uint8 InMipLevel = 0, EPixelFormat InFormat = PF_Unknown,
		uint16 InFirstArraySlice = 0, uint16 InNumArraySlices = 0)
		: FRHITextureUAVCreateInfo(InMipLevel, InFormat, InFirstArraySlice, InNumArraySlices)
		, Texture(InTexture)
	{
	}

	FRDGTextureRef Texture = nullptr;
};

class FRDGBufferSRVDesc final : public FRHIBufferSRVCreateInfo
{
public:
	FRDGBufferSRVDesc() = default;
	FRDGBufferSRVDesc(FRDGBufferRef InBuffer, EPixelFormat InFormat = PF_Unknown, uint32 InStartOffsetBytes = 0,
		uint32 InNumElements = 0)
		: FRHIBufferSRVCreateInfo(InFormat, InStartOffsetBytes, InNumElements)
		, Buffer(InBuffer)
	{
	}

	FRDGBufferRef Buffer = nullptr;
};

/** Append, Consume and IncrementCounter need bSupportsAppendBuffer or bSupportsAtomicCounter. Their counter is
 * FRHIUnorderedAccessView::GetKernelCounter. */
class FRDGBufferUAVDesc final : public FRHIBufferUAVCreateInfo
{
public:
	FRDGBufferUAVDesc() = default;
	FRDGBufferUAVDesc(FRDGBufferRef InBuffer, EPixelFormat InFormat = PF_Unknown)
		: FRHIBufferUAVCreateInfo(InFormat)
		, Buffer(InBuffer)
	{
	}

	FRDGBufferRef Buffer = nullptr;
};

class DRYDOCK_API FRDGView : public FRDGResource
{
public:
	const ERDGViewType Type;

	virtual FRDGViewableResource* GetParent() const = 0;

	/** Counts the views of a graph in the order of their creation. */
	int32 GetViewIndex() const { return ViewIndex; }

protected:
	FRDGView(const TCHAR* InName, ERDGViewType InType)
		: FRDGResource(InName)
		, Type(InType)
	{
	}

	/** Without the check of GetRHI. */
	static FRHIResource* GetParentRHI(const FRDGResource& Parent);

private:
	friend class FRDGBuilder;
	friend class Drydock::FRDGExecutor;

	int32 ViewIndex = -1;

	/** The RHI view, made from the parent's RHI object. */
	virtual TRefCountPtr<FRHIResource> CreateRHI() const = 0;
};

class DRYDOCK_API FRDGShaderResourceView : public FRDGView
{
public:
	FRHIShaderResourceView* GetRHI() const { return static_cast<FRHIShaderResourceView*>(FRDGResource::GetRHI()); }

protected:
	using FRDGView::FRDGView;
};

class DRYDOCK_API FRDGUnorderedAccessView : public FRDGView
{
public:
	const ERDGUnorderedAccessViewFlags Flags;

	FRHIUnorderedAccessView* GetRHI() const { return static_cast<FRHIUnorderedAccessView*>(FRDGResource::GetRHI()); }

protected:
	FRDGUnorderedAccessView(const TCHAR* InName, ERDGViewType InType, ERDGUnorderedAccessViewFlags InFlags)
		: FRDGView(InName, InType)
		, Flags(InFlags)
	{
	}
};

class DRYDOCK_API FRDGTextureSRV final : public FRDGShaderResourceView
{
public:
	const FRDGTextureSRVDesc Desc;

	FRDGTexture* GetParent() const override { return Desc.Texture; }
	FRDGTextureSubresourceRange GetSubresourceRange() const;

private:
	friend class FRDGBuilder;
	explicit FRDGTextureSRV(const FRDGTextureSRVDesc& InDesc)
		: FRDGShaderResourceView(InDesc.Texture->Name, ERDGViewType::TextureSRV)
		, Desc(InDesc)
	{
	}
	TRefCountPtr<FRHIResource> CreateRHI() const override;
};

class DRYDOCK_API FRDGTextureUAV final : public FRDGUnorderedAccessView
{
public:
	const FRDGTextureUAVDesc Desc;

	FRDGTexture* GetParent() const override { return Desc.Texture; }
	FRDGTextureSubresourceRange GetSubresourceRange() const;

private:
	friend class FRDGBuilder;
	FRDGTextureUAV(const FRDGTextureUAVDesc& InDesc, ERDGUnorderedAccessViewFlags InFlags)
		: FRDGUnorderedAccessView(InDesc.Texture->Name, ERDGViewType::TextureUAV, InFlags)
		, Desc(InDesc)
	{
	}
	TRefCountPtr<FRHIResource> CreateRHI() const override;
};

class DRYDOCK_API FRDGBufferSRV final : public FRDGShaderResourceView
{
public:
	const FRDGBufferSRVDesc Desc;

	FRDGBuffer* GetParent() const override { return Desc.Buffer; }

private:
	friend class FRDGBuilder;
	explicit FRDGBufferSRV(const FRDGBufferSRVDesc& InDesc)
		: FRDGShaderResourceView(InDesc.Buffer->Name, ERDGViewType::BufferSRV)
		, Desc(InDesc)
	{
	}
	TRefCountPtr<FRHIResource> CreateRHI() const override;
};

class DRYDOCK_API FRDGBufferUAV final : public FRDGUnorderedAccessView
{
public:
	const FRDGBufferUAVDesc Desc;

	FRDGBuffer* GetParent() const override { return Desc.Buffer; }

private:
	friend class FRDGBuilder;
	FRDGBufferUAV(const FRDGBufferUAVDesc& InDesc, ERDGUnorderedAccessViewFlags InFlags)
		: FRDGUnorderedAccessView(InDesc.Buffer->Name, ERDGViewType::BufferUAV, InFlags)
		, Desc(InDesc)
	{
	}
	TRefCountPtr<FRHIResource> CreateRHI() const override;
};

// Uniform buffers ---------------------------------------------------------------------------------------------------

/** A uniform buffer whose struct may hold graph resources; a pass that refers to it reads all of them. */
class DRYDOCK_API FRDGUniformBuffer : public FRDGResource
{
public:
	const FShaderParametersMetadata& GetMetadata() const { return *Metadata; }
	/** The struct it was created with. */
	const void* GetContents() const { return ContentsData; }

protected:
	FRDGUniformBuffer(const FShaderParametersMetadata* InMetadata, const void* InContents, const TCHAR* InName)
		: FRDGResource(InName)
		, Metadata(InMetadata)
		, ContentsData(InContents)
	{
	}

private:
	friend class FRDGBuilder;
	friend class Drydock::FRDGExecutor;

	const FShaderParametersMetadata* Metadata;
	const void* ContentsData;
};

/** The result of GetParameters: gives the struct, by -> or *. */
template<typename ParameterStructType>
class TRDGParameterStruct
{
public:
	explicit TRDGParameterStruct(const ParameterStructType* InParameters)
		: Parameters(InParameters)
	{
	}

	const ParameterStructType* operator->() const { return Parameters; }
	const ParameterStructType& operator*() const { return *Parameters; }
	const ParameterStructType* GetContents() const { return Parameters; }

private:
	const ParameterStructType* Parameters;
};

template<typename ParameterStructType>
class TRDGUniformBuffer final : public FRDGUniformBuffer
{
public:
	const TRDGParameterStruct<ParameterStructType>& GetParameters() const { return ParameterStruct; }
	const ParameterStructType* GetContents() const
	{
		return static_cast<const ParameterStructType*>(FRDGUniformBuffer::GetContents());
	}
	const ParameterStructType* operator->() const { return GetContents(); }

private:
	friend class FRDGBuilder;
	TRDGUniformBuffer(const ParameterStructType* InParameters, const TCHAR* InName)
		: FRDGUniformBuffer(ParameterStructType::FTypeInfo::GetStructMetadata(), InParameters, InName)
		, ParameterStruct(InParameters)
	{
	}

	const TRDGParameterStruct<ParameterStructType> ParameterStruct;
};

/** "Texture of this graph, else null" for optional inputs. */
inline FRDGTextureRef GetIfProduced(FRDGTextureRef Texture, FRDGTextureRef FallbackTexture = nullptr)
{
	return Texture && Texture->HasBeenProduced() ? Texture : FallbackTexture;
}

inline FRDGBufferRef GetIfProduced(FRDGBufferRef Buffer, FRDGBufferRef FallbackBuffer = nullptr)
{
	return Buffer && Buffer->HasBeenProduced() ? Buffer : FallbackBuffer;
}

/** The engine's older name, and its casts; the resource must be of that type. */
using FRDGParentResource = FRDGViewableResource;
inline FRDGTexture* GetAsTexture(FRDGViewableResource* Resource)
{
	return static_cast<FRDGTexture*>(Resource);
}
inline FRDGBuffer* GetAsBuffer(FRDGViewableResource* Resource)
{
	return static_cast<FRDGBuffer*>(Resource);
}

inline bool HasBeenProduced(const FRDGViewableResource* Resource)
{
	return Resource && Resource->HasBeenProduced();
}
