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

std::string FindTooManyGroups(const FBoundShader& Shader, const uint32 (&Counts)[3])
{
	constexpr uint64 Several = 4;
	const FShaderReflection& Reflection = Shader.GetReflection();
	uint64 Taken = 0;
	const FKernelMip* Largest = nullptr;
	std::string Name;
	bool bCounts = Reflection.bGroups || !Shader.RWBuffers.empty();
	for (size_t Slot = 0; Slot < std::min(Shader.RWTextures.size(), Reflection.RWTextures.size()); ++Slot)
	{
		const FKernelMip& Mip = Shader.RWTextures[Slot].Mips[0];
		const int32 Sizes[3] = {Mip.SizeX, Mip.SizeY, Mip.SizeZ};
		uint64 Groups = 1;
		for (int32 Axis = 0; Axis < 3; ++Axis)
		{
			Groups *= uint64((Sizes[Axis] + Reflection.GroupSize[Axis] - 1) / Reflection.GroupSize[Axis]);
		}
		bCounts = bCounts || Reflection.RWTextures[Slot].Scalar != EShaderScalar::Float;
		const bool bLarger = !Largest || int64(Mip.SizeX) * Mip.SizeY > int64(Largest->SizeX) * Largest->SizeY;
		Name = bLarger ? Reflection.RWTextures[Slot].Name : Name;
		Largest = bLarger ? &Mip : Largest;
		Taken += Groups;
	}
	if (bCounts || !Largest || uint64(Counts[0]) * Counts[1] * Counts[2] < Several * Taken)
	{
		return {};
	}
	const auto List = [](auto X, auto Y)
	{
		return std::to_string(X) + " x " + std::to_string(Y);
	};
	return "the dispatch has " + List(Counts[0], Counts[1]) + " groups of " +
		   List(Reflection.GroupSize[0], Reflection.GroupSize[1]) + " threads, and " + Name + " has " +
		   List(Largest->SizeX, Largest->SizeY) + " texels, which " + std::to_string(Taken) +
		   (Taken == 1 ? " group covers" : " groups cover") +
		   ": a dispatch counts groups, as FComputeShaderUtils::GetGroupCount(Size, GroupSize) gives them";
}

} // namespace Drydock
