// Describes a view step by step, as code for engines from 5.4 does. Source: the engine's FRHIViewDesc, as public
// plugins name it.
#pragma once

#include "RHIViews.h"

struct FRHIViewDesc
{
	enum class EBufferType : uint8
	{
		Unknown,
		Typed,
		Structured,
		AccelerationStructure,
		Raw
	};

	/** Setters that return the initializer itself. */
#define DRYDOCK_VIEW_SETTER(Type, Name, Parameters, Code) \
	Type& Name Parameters \
	{ \
		Code; \
		return *this; \
	}

	/** A part of a texture. The dimension is the texture's own. */
	struct FTextureSRV
	{
		struct FInitializer
		{
			DRYDOCK_VIEW_SETTER(FInitializer, SetDimension, (ETextureDimension), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetDimensionFromTexture, (const FRHITexture*), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetFormat, (EPixelFormat Format), Info.Format = Format)
			DRYDOCK_VIEW_SETTER(FInitializer, SetMipRange, (uint8 First, uint8 Num), Info.MipLevel = First;
								Info.NumMipLevels = Num)
			DRYDOCK_VIEW_SETTER(FInitializer, SetArrayRange, (uint16 First, uint16 Num), Info.FirstArraySlice = First;
								Info.NumArraySlices = Num)

			FRHITextureSRVCreateInfo Info;
		};
	};
	struct FTextureUAV
	{
		struct FInitializer
		{
			DRYDOCK_VIEW_SETTER(FInitializer, SetDimension, (ETextureDimension), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetDimensionFromTexture, (const FRHITexture*), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetFormat, (EPixelFormat Format), Info.Format = Format)
			DRYDOCK_VIEW_SETTER(FInitializer, SetMipLevel, (uint8 Level), Info.MipLevel = Level)
			DRYDOCK_VIEW_SETTER(FInitializer, SetArrayRange, (uint16 First, uint16 Num), Info.FirstArraySlice = First;
								Info.NumArraySlices = Num)

			FRHITextureUAVCreateInfo Info;
		};
	};

	/** A part of a buffer. The stride and, without a format, the type are the buffer's own. */
	struct FBufferSRV
	{
		struct FInitializer
		{
			DRYDOCK_VIEW_SETTER(FInitializer, SetType, (EBufferType), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetTypeFromBuffer, (const FRHIBuffer*), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetFormat, (EPixelFormat Format), Info.Format = Format)
			DRYDOCK_VIEW_SETTER(FInitializer, SetOffsetInBytes, (uint32 Offset), Info.StartOffsetBytes = Offset)
			DRYDOCK_VIEW_SETTER(FInitializer, SetStride, (uint32), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetNumElements, (uint32 Num), Info.NumElements = Num)

			FRHIBufferSRVCreateInfo Info;
		};
	};
	struct FBufferUAV
	{
		struct FInitializer
		{
			DRYDOCK_VIEW_SETTER(FInitializer, SetType, (EBufferType), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetTypeFromBuffer, (const FRHIBuffer*), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetFormat, (EPixelFormat Format), Info.Format = Format)
			DRYDOCK_VIEW_SETTER(FInitializer, SetOffsetInBytes, (uint32 Offset), Info.StartOffsetBytes = Offset)
			DRYDOCK_VIEW_SETTER(FInitializer, SetStride, (uint32), )
			DRYDOCK_VIEW_SETTER(FInitializer, SetNumElements, (uint32 Num), Info.NumElements = Num)
			DRYDOCK_VIEW_SETTER(FInitializer, SetAtomicCounter, (bool bOn), Info.bSupportsAtomicCounter = bOn)
			DRYDOCK_VIEW_SETTER(FInitializer, SetAppendBuffer, (bool bOn), Info.bSupportsAppendBuffer = bOn)

			FRHIBufferUAVCreateInfo Info;
		};
	};
#undef DRYDOCK_VIEW_SETTER

	static FTextureSRV::FInitializer CreateTextureSRV()
	{
		return FTextureSRV::FInitializer();
	}
	static FTextureUAV::FInitializer CreateTextureUAV()
	{
		return FTextureUAV::FInitializer();
	}
	static FBufferSRV::FInitializer CreateBufferSRV()
	{
		return FBufferSRV::FInitializer();
	}
	static FBufferUAV::FInitializer CreateBufferUAV()
	{
		return FBufferUAV::FInitializer();
	}
};
