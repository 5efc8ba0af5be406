// The two sides of a UTexture: the render thread's, and its bytes. FTexture and its kin lie in RenderResource.h.
// Source: engine TextureResource.h.
#pragma once

#include "RenderResource.h"

class DRYDOCK_API FTextureResource : public FTexture
{
public:
	FRHITexture* GetTexture2DRHI() const { return TextureRHI; }
	FRHITexture* GetTexture3DRHI() const { return TextureRHI; }
};

/** Bytes that are locked while somebody writes them. */
class FByteBulkData
{
public:
	void* Lock(uint32) { return Bytes.GetData(); }
	const void* LockReadOnly() const { return Bytes.GetData(); }
	/** Locked: other bytes, 0. */
	void* Realloc(int64 NumBytes)
	{
		Bytes.SetNumZeroed(int32(NumBytes));
		return Bytes.GetData();
	}
	void Unlock() const {}
	int64 GetBulkDataSize() const { return Bytes.Num(); }

private:
	TArray<uint8> Bytes;
};
enum ELockFlags
{
	LOCK_READ_ONLY = 1,
	LOCK_READ_WRITE = 2,
};

struct FTexture2DMipMap
{
	int32 SizeX = 0;
	int32 SizeY = 0;
	FByteBulkData BulkData; // row by row, as the format stores them
};

struct FTexturePlatformData
{
	int32 SizeX = 0;
	int32 SizeY = 0;
	EPixelFormat PixelFormat = PF_Unknown;
	TArray<FTexture2DMipMap> Mips; // one
};
