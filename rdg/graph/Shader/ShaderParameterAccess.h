// Parameter-struct members that declare an access without binding anything to the shader: copies, indirect arguments,
// resources that a lambda touches itself. Source: engine ShaderParameterMacros.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIAccess.h"
#include "RenderGraphFwd.h"

/** A texture and how the pass will touch it. */
class FRDGTextureAccess
{
public:
	FRDGTextureAccess() = default;
	FRDGTextureAccess(FRDGTexture* InTexture, ERHIAccess InAccess)
		: Texture(InTexture)
		, Access(InAccess)
	{
	}

	FRDGTexture* GetTexture() const { return Texture; }
	ERHIAccess GetAccess() const { return Access; }

	operator FRDGTexture*() const { return Texture; }
	FRDGTexture* operator->() const { return Texture; }
	explicit operator bool() const { return Texture != nullptr; }

protected:
	FRDGTexture* Texture = nullptr;
	ERHIAccess Access = ERHIAccess::Unknown;
};

/** A buffer and how the pass will touch it. */
class FRDGBufferAccess
{
public:
	FRDGBufferAccess() = default;
	FRDGBufferAccess(FRDGBuffer* InBuffer, ERHIAccess InAccess)
		: Buffer(InBuffer)
		, Access(InAccess)
	{
	}

	FRDGBuffer* GetBuffer() const { return Buffer; }
	ERHIAccess GetAccess() const { return Access; }

	operator FRDGBuffer*() const { return Buffer; }
	FRDGBuffer* operator->() const { return Buffer; }
	explicit operator bool() const { return Buffer != nullptr; }

protected:
	FRDGBuffer* Buffer = nullptr;
	ERHIAccess Access = ERHIAccess::Unknown;
};

/** The access is part of the type: RDG_TEXTURE_ACCESS. */
template<ERHIAccess InAccess>
class TRDGTextureAccess : public FRDGTextureAccess
{
public:
	TRDGTextureAccess()
		: FRDGTextureAccess(nullptr, InAccess)
	{
	}
	TRDGTextureAccess(FRDGTexture* InTexture)
		: FRDGTextureAccess(InTexture, InAccess)
	{
	}
};

template<ERHIAccess InAccess>
class TRDGBufferAccess : public FRDGBufferAccess
{
public:
	TRDGBufferAccess()
		: FRDGBufferAccess(nullptr, InAccess)
	{
	}
	TRDGBufferAccess(FRDGBuffer* InBuffer)
		: FRDGBufferAccess(InBuffer, InAccess)
	{
	}
};

/** Any number of accesses: RDG_TEXTURE_ACCESS_ARRAY. */
class FRDGTextureAccessArray : public TArray<FRDGTextureAccess>
{
public:
	using TArray<FRDGTextureAccess>::TArray;
};

class FRDGBufferAccessArray : public TArray<FRDGBufferAccess>
{
public:
	using TArray<FRDGBufferAccess>::TArray;
};
