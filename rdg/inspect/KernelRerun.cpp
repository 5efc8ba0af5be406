// Copies textures, and runs kernels on them.
#include "KernelRerun.h"

#include "PixelFormatConversion.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

FOwnTexture::FOwnTexture(const FKernelTexture& Like, ETexelStorage Storage)
	: Mip(Like.Mips[0])
	, Texture(Like)
{
	Mip.RowPitch = Mip.SizeX * GetTexelStorageInfo(Storage).BytesPerTexel;
	Mip.SlicePitch = int64_t(Mip.RowPitch) * Mip.SizeY;
	Memory.resize(size_t(Mip.SlicePitch) * size_t(Mip.SizeZ) + 2 * TextureMargin);
	Mip.Data = Memory.data() + TextureMargin;
	for (int32_t Row = 0; Storage == Like.Storage && Row < Mip.SizeY * Mip.SizeZ; ++Row)
	{
		const int32_t y = Row % Mip.SizeY, z = Row / Mip.SizeY;
		std::memcpy(Mip.Data + z * Mip.SlicePitch + int64_t(y) * Mip.RowPitch,
			Like.Mips[0].Data + z * Like.Mips[0].SlicePitch + int64_t(y) * Like.Mips[0].RowPitch, size_t(Mip.RowPitch));
	}
	Texture.Storage = Storage;
	Texture.NumMips = 1;
}

FKernelTexture FOwnTexture::Get() const
{
	FKernelTexture Own = Texture;
	Own.Mips = &Mip;
	return Own;
}

FKernelRerun::FKernelRerun(const FBoundShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole)
	: Shader(InShader)
	, Whole(InWhole)
	, Sandbox(InArgs, InShader.GetReflection())
	, Args(Sandbox.GetArgs())
	, Textures(InShader.Textures)
	, Targets(InArgs.Targets, InArgs.Targets + InArgs.NumTargets)
	, Constants(InShader.ConstantData)
{
	for (FKernelTarget& Target : Targets)
	{
		Owned.push_back(std::make_unique<FOwnTexture>(Target.Texture, Target.Texture.Storage));
		Target.Texture = Owned.back()->Get();
		Written.push_back(Target.Texture);
	}
	for (size_t Slot = 0; Targets.empty() && Slot < Shader.RWTextures.size(); ++Slot)
	{
		Written.push_back(Args.RWTextures[Slot]);
	}
	for (const std::vector<uint8_t>& Buffer : Constants)
	{
		ConstantBuffers.push_back(Buffer.data());
	}
	Args.Textures = Textures.data();
	Args.Targets = Targets.data();
	Args.ConstantBuffers = ConstantBuffers.data();
}

FOwnTexture& FKernelRerun::OwnInput(size_t Slot, ETexelStorage Storage)
{
	Owned.push_back(std::make_unique<FOwnTexture>(Textures[Slot], Storage));
	Textures[Slot] = Owned.back()->Get();
	return *Owned.back();
}

void FKernelRerun::SetConstant(const FShaderConstant& Constant, float Value)
{
	for (int32_t Column = 0; Column < Constant.Columns; ++Column)
	{
		std::memcpy(Constants[Constant.Buffer].data() + Constant.Offset + size_t(Column) * sizeof(float), &Value,
			sizeof(float));
	}
}

void FKernelRerun::Run() const
{
	const int32_t GroupRows = std::max(1, Shader.GetReflection().GroupSize[1]);
	const FIntVector Rows(0, 16 * GroupRows, 0);
	const uint64_t Number = FBoundShader::GetNewNumber();
	ForEachTile(
		Whole, Shader.GetReflection().bGroupsInOrder ? FIntVector(Whole.MaxX, Whole.MaxY, Whole.MaxZ) : Rows,
		[&](const FKernelTile& Tile) { Shader.Run(Args, Tile, Number); },
		Shader.bDouble ? EDenormals::Keep : EDenormals::Flush);
}

} // namespace Drydock
