// A texture in plain memory for sampler tests: random or given texels, mips, slices, the margins that kernels may read;
// and a loop over the lane widths of the CPU.
#pragma once

#include "LanesDispatch.h"
#include "PixelFormatConversion.h"
#include "ShaderKernel.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace Drydock::Tests
{

class FTestTexture
{
public:
	using FTexel = std::array<double, 4>;

	/** All texels zero, margins poisoned. Mips halve, rounding down. bIs3D halves the depth too; layers stay. */
	FTestTexture(
		ETexelStorage Storage, int32_t SizeX, int32_t SizeY, int32_t SizeZ = 1, int32_t NumMips = 1, bool bIs3D = false)
		: Bytes(GetTexelStorageInfo(Storage).BytesPerTexel)
	{
		size_t Offset = 64;
		for (int32_t Mip = 0; Mip < NumMips; ++Mip)
		{
			FKernelMip M = {};
			M.SizeX = std::max(1, SizeX >> Mip);
			M.SizeY = std::max(1, SizeY >> Mip);
			M.SizeZ = bIs3D ? std::max(1, SizeZ >> Mip) : SizeZ;
			M.RowPitch = (M.SizeX * Bytes + 63) / 64 * 64;
			M.SlicePitch = int64_t(M.RowPitch) * M.SizeY;
			Mips.push_back(M);
			Offset += size_t(M.SlicePitch) * size_t(M.SizeZ) + 64;
		}
		Memory.assign(Offset, 0xA5);
		size_t Place = 64;
		for (FKernelMip& M : Mips)
		{
			M.Data = Memory.data() + Place;
			std::memset(M.Data, 0, size_t(M.SlicePitch) * size_t(M.SizeZ));
			Place += size_t(M.SlicePitch) * size_t(M.SizeZ) + 64;
		}
		Texture = {Mips.data(), NumMips, Storage, uint8_t(bIs3D), 0};
	}
	FTestTexture(const FTestTexture&) = delete;
	FTestTexture& operator=(const FTestTexture&) = delete;

	uint8_t* At(int32_t X, int32_t Y, int32_t Z = 0, int32_t Mip = 0)
	{
		const FKernelMip& M = Mips[size_t(Mip)];
		return M.Data + Z * M.SlicePitch + int64_t(Y) * M.RowPitch + int64_t(X) * Bytes;
	}

	void Write(const FTexel& Texel, int32_t X, int32_t Y, int32_t Z = 0, int32_t Mip = 0)
	{
		EncodeTexel(Texture.Storage, Texel.data(), At(X, Y, Z, Mip));
	}

	FTexel Read(int32_t X, int32_t Y, int32_t Z = 0, int32_t Mip = 0)
	{
		FTexel Texel;
		DecodeTexel(Texture.Storage, At(X, Y, Z, Mip), Texel.data());
		return Texel;
	}

	/** Every texel of every mip between Low and High. */
	void FillRandom(uint32_t Seed, double Low, double High)
	{
		std::mt19937 Engine(Seed);
		std::uniform_real_distribution<double> Value(Low, High);
		ForEachTexel(
			[&](int32_t X, int32_t Y, int32_t Z, int32_t Mip) {
				Write({Value(Engine), Value(Engine), Value(Engine), Value(Engine)}, X, Y, Z, Mip);
			});
	}

	template<typename F>
	void ForEachTexel(F f)
	{
		for (int32_t Mip = 0; Mip < Texture.NumMips; ++Mip)
		{
			for (int32_t Z = 0; Z < Mips[size_t(Mip)].SizeZ; ++Z)
			{
				for (int32_t Y = 0; Y < Mips[size_t(Mip)].SizeY; ++Y)
				{
					for (int32_t X = 0; X < Mips[size_t(Mip)].SizeX; ++X)
					{
						f(X, Y, Z, Mip);
					}
				}
			}
		}
	}

	/** Texels, paddings and margins. */
	const std::vector<uint8_t>& GetMemory() const { return Memory; }

	std::vector<FKernelMip> Mips;
	FKernelTexture Texture;

private:
	std::vector<uint8_t> Memory;
	int32_t Bytes;
};

/** Runs f<Real, N>() at every width of the CPU. */
template<typename F>
void ForEachWidth(F f)
{
	f.template operator()<float, 4>();
	f.template operator()<double, 2>();
	if (AreLanesSupported(false, 8))
	{
		f.template operator()<float, 8>();
		f.template operator()<double, 4>();
	}
	if (AreLanesSupported(false, 16))
	{
		f.template operator()<float, 16>();
		f.template operator()<double, 8>();
	}
}

/** Sample bits 8 unless said otherwise, no bias, black transparent border. */
inline FKernelSampler MakeSampler(EKernelFilter Filter, EKernelAddress Address, uint8_t SampleBits = 8)
{
	return {Filter, Address, Address, Address, SampleBits, 0, {0, 0, 0, 0}};
}

} // namespace Drydock::Tests
