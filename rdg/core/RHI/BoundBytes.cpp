// Sums the sizes of a shader's views.
#include "BoundBytes.h"

#include "PixelFormatConversion.h"

#include <algorithm>

namespace Drydock
{

namespace
{

uint64 GetViewBytes(const FKernelTexture& View)
{
	uint64 Texels = 0;
	for (int32 Mip = 0; Mip < View.NumMips; ++Mip)
	{
		const FKernelMip& At = View.Mips[Mip];
		Texels += uint64(At.SizeX) * uint64(At.SizeY) * uint64(At.SizeZ);
	}
	return Texels * GetTexelStorageInfo(View.Storage).BytesPerTexel;
}

} // namespace

uint64 GetBytesBoundForReading(const FBoundShader& Shader)
{
	uint64 Bytes = 0;
	for (const FKernelTexture& View : Shader.Textures)
	{
		Bytes += GetViewBytes(View);
	}
	for (const FKernelBuffer& View : Shader.Buffers)
	{
		Bytes += View.SizeInBytes;
	}
	return Bytes;
}

uint64 GetBytesBoundForWriting(const FBoundShader& Shader, uint64 NumThreads)
{
	uint64 Bytes = 0;
	for (const FKernelTexture& View : Shader.RWTextures)
	{
		Bytes += std::min(GetViewBytes(View), NumThreads * GetTexelStorageInfo(View.Storage).BytesPerTexel);
	}
	for (const FKernelBuffer& View : Shader.RWBuffers)
	{
		Bytes += std::min<uint64>(View.SizeInBytes, NumThreads * View.Stride);
	}
	return Bytes;
}

} // namespace Drydock
