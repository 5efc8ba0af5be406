// Makes constants, pictures and buffers.
#include "MadeArguments.h"

#include "PixelFormatConversion.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace Drydock::Test
{

namespace
{

constexpr uint32_t NumElements = 512; // of a buffer
constexpr int32_t NumMips = 3;
constexpr int32_t NumSlices = 6;

bool Has(const std::string& Name, const char* Part)
{
	return Name.find(Part) != std::string::npos;
}

} // namespace

FMadeArguments::FMadeArguments(const FShaderReflection& InReflection, EMadePictures Pictures, uint32_t Seed)
	: Reflection(InReflection)
	, Random(Seed)
{
	MakeConstants(Random);
	for (const FShaderResource& Resource : Reflection.Textures)
	{
		Textures.push_back(MakeTexture(Resource, false, Pictures));
	}
	for (const FShaderResource& Resource : Reflection.RWTextures)
	{
		RWTextures.push_back(MakeTexture(Resource, true, Pictures));
	}
	for (const FShaderResource& Resource : Reflection.Buffers)
	{
		Buffers.push_back(MakeBuffer(Resource, false));
	}
	for (const FShaderResource& Resource : Reflection.RWBuffers)
	{
		RWBuffers.push_back(MakeBuffer(Resource, true));
	}
	for (const FShaderResource& Resource : Reflection.Samplers)
	{
		const EKernelAddress Address = Has(Resource.Name, "Wrap") ? EKernelAddress::Wrap : EKernelAddress::Clamp;
		Samplers.push_back({Has(Resource.Name, "Point") ? EKernelFilter::Point : EKernelFilter::Bilinear, Address,
			Address, Address, 0, 0, {}});
	}
	for (int32_t Target = 0; Target < Reflection.NumTargets; ++Target)
	{
		FShaderResource Picture;
		FKernelTarget View = {};
		View.Texture = MakeTexture(Picture, true, Pictures);
		View.WriteMask = 15;
		Targets.push_back(View);
	}
	const FKernelInterpolant Uv = {
		{0, 0, -1, 1}, {1.0 / GMadeSizeX, 0, 2.0 / GMadeSizeX, 0}, {0, 1.0 / GMadeSizeY, 0, -2.0 / GMadeSizeY}};
	Interpolants.assign(size_t(std::max(Reflection.NumInterpolants, 1)), Uv);
	Args = {ConstantPointers.data(), Textures.data(), RWTextures.data(), Samplers.data(), Buffers.data(),
		RWBuffers.data(), Targets.data(), Interpolants.data(), int32_t(Targets.size()), nullptr, nullptr};
}

FKernelTile FMadeArguments::GetWhole() const
{
	if (Reflection.Stage == EShaderStage::Pixel)
	{
		return {0, 0, 0, GMadeSizeX, GMadeSizeY, 1};
	}
	const auto RoundUp = [this](int32_t Size, int Axis)
	{
		const int32_t Group = Reflection.GroupSize[Axis];
		return (Size + Group - 1) / Group * Group;
	};
	return {0, 0, 0, RoundUp(GMadeSizeX, 0), RoundUp(GMadeSizeY, 1), RoundUp(1, 2)};
}

/** What parameters of that name hold in a frame. */
float FMadeArguments::MakeNumber(const std::string& Name, int32_t Component, std::mt19937& Engine) const
{
	const float Size = Component % 2 == 0 ? GMadeSizeX : GMadeSizeY;
	const bool bUv = Has(Name, "UV");
	if (Has(Name, "Inverse") || Has(Name, "InvSize") || Has(Name, "InvExtent") || Has(Name, "TexelSize"))
	{
		return 1.0f / Size;
	}
	if (Has(Name, "SizeAndInv") || Has(Name, "AndInvSize"))
	{
		return Component < 2 ? Size : 1.0f / Size;
	}
	if (bUv && Has(Name, "Min"))
	{
		return 0.5f / Size;
	}
	if (bUv && Has(Name, "Max"))
	{
		return 1.0f - 0.5f / Size;
	}
	if (Has(Name, "ViewportMin") || Has(Name, "RectMin"))
	{
		return 0.0f;
	}
	if (Has(Name, "Extent") || Has(Name, "ViewportMax") || Has(Name, "RectMax") || (Has(Name, "Size") && !bUv))
	{
		return Size;
	}
	if (Has(Name, "Exposure"))
	{
		return 1.0f;
	}
	return std::uniform_real_distribution<float>(0.125f, 1.0f)(Engine);
}

void FMadeArguments::MakeConstants(std::mt19937& Engine)
{
	for (const FShaderConstantBuffer& Buffer : Reflection.ConstantBuffers)
	{
		Constants.emplace_back(Buffer.Size, uint8_t(0));
	}
	for (const FShaderConstant& Constant : Reflection.Constants)
	{
		std::vector<uint8_t>& Bytes = Constants[Constant.Buffer];
		const bool bMatrix = Constant.Rows > 1;
		for (int32_t Element = 0; Element < std::max(Constant.NumElements, 1); ++Element)
		{
			for (int32_t i = 0; i < Constant.Rows * Constant.Columns; ++i)
			{
				const int32_t Row = i / Constant.Columns;
				const int32_t Column = i % Constant.Columns;
				const int32_t Vector = Constant.bRowMajor ? Row : Column;
				const int32_t Inside = Constant.bRowMajor ? Column : Row;
				const size_t At =
					Constant.Offset + size_t(Element) * Constant.ArrayStride +
					(bMatrix ? size_t(Vector) * Constant.MatrixStride + size_t(Inside) * 4 : size_t(Column) * 4);
				float Value = MakeNumber(Constant.Name, i, Engine);
				if (bMatrix) // near the identity, as a change of colours or of spaces is
				{
					Value = (Row == Column ? 1.0f : 0.0f) + 0.125f * Value;
				}
				const uint32_t Whole =
					Has(Constant.Name, "Size") || Has(Constant.Name, "Max") ? uint32_t(Value) : Engine() % 4;
				uint32_t Bits;
				std::memcpy(&Bits, &Value, 4);
				Bits = Constant.Scalar == EShaderScalar::Float ? Bits : Whole;
				if (At + 4 <= Bytes.size())
				{
					std::memcpy(Bytes.data() + At, &Bits, 4);
				}
			}
		}
	}
	for (const std::vector<uint8_t>& Bytes : Constants)
	{
		ConstantPointers.push_back(Bytes.data());
	}
}

const FKernelTexture& FMadeArguments::MakeTexture(
	const FShaderResource& Resource, bool bWritten, EMadePictures Pictures)
{
	FMadeTexture& Texture = *Made.emplace_back(std::make_unique<FMadeTexture>());
	const bool bUint = Resource.Scalar != EShaderScalar::Float;
	const int32_t Channels = bUint && bWritten ? Resource.NumComponents : 4;
	const ETexelStorage Storage = !bUint          ? ETexelStorage::RGBA32_FLOAT
								  : Channels == 1 ? ETexelStorage::R32_UINT
								  : Channels == 2 ? ETexelStorage::RG32_UINT
												  : ETexelStorage::RGBA32_UINT;
	const bool b3D = Resource.Dimension == EShaderDimension::Texture3D;
	const bool bSlices = b3D || Resource.Dimension == EShaderDimension::Texture2DArray ||
						 Resource.Dimension == EShaderDimension::TextureCube;
	const bool bSquare = Resource.Dimension == EShaderDimension::TextureCube;
	const int32_t Mips = bWritten || Resource.bImplicitLevel ? 1 : NumMips; // a choice of mips would want quads
	const size_t Bytes = size_t(Channels) * 4;
	size_t Size = 64;
	for (int32_t m = 0; m < Mips; ++m)
	{
		const int32_t X = GMadeSizeX >> m;
		const int32_t Y = bSquare ? X : GMadeSizeY >> m;
		const int32_t Z = b3D ? std::max(NumSlices >> m, 1) : bSlices ? NumSlices : 1;
		Texture.Mips.push_back({reinterpret_cast<uint8_t*>(Size), X, Y, Z, int32_t(size_t(X) * Bytes),
			int64_t(size_t(X) * size_t(Y) * Bytes)});
		Size += size_t(X) * size_t(Y) * size_t(Z) * Bytes + 64;
	}
	Texture.Memory.resize(Size);
	const float Phase = std::uniform_real_distribution<float>(0, 6)(Random);
	std::uniform_real_distribution<float> Noise(0, 4);
	for (FKernelMip& Mip : Texture.Mips)
	{
		Mip.Data = Texture.Memory.data() + reinterpret_cast<size_t>(Mip.Data);
		const size_t PerSlice = size_t(Mip.SizeX) * size_t(Mip.SizeY) * size_t(Channels);
		for (size_t i = 0; i < PerSlice * size_t(Mip.SizeZ); ++i)
		{
			const float U = float(i / size_t(Channels) % size_t(Mip.SizeX)) / float(Mip.SizeX);
			const float V = float(i % PerSlice / size_t(Channels) / size_t(Mip.SizeX)) / float(Mip.SizeY);
			const float Value = Pictures == EMadePictures::Noisy
									? Noise(Random)
									: 1.0f + 0.75f * std::sin(Phase + 4 * U + float(i % 4)) * std::cos(Phase + 3 * V);
			uint32_t Bits;
			std::memcpy(&Bits, &Value, 4);
			Bits = bUint ? uint32_t(Value * 8) : Bits;
			std::memcpy(Mip.Data + i * 4, &Bits, 4);
		}
	}
	Texture.View = {Texture.Mips.data(), Mips, Storage, uint8_t(b3D), 0};
	return Texture.View;
}

FKernelBuffer FMadeArguments::MakeBuffer(const FShaderResource& Resource, bool bWritten)
{
	const bool bTyped = Resource.Dimension == EShaderDimension::TypedBuffer;
	const bool bUint = Resource.Scalar != EShaderScalar::Float;
	const bool bFour = !bWritten || Resource.NumComponents > 2;
	const ETexelStorage Storage = bUint ? (bFour ? ETexelStorage::RGBA32_UINT : ETexelStorage::R32_UINT)
										: (bFour ? ETexelStorage::RGBA32_FLOAT : ETexelStorage::R32_FLOAT);
	const uint32_t Stride =
		bTyped ? GetTexelStorageInfo(Storage).BytesPerTexel : std::max<uint32_t>(Resource.Stride, 4);
	std::vector<uint32_t>& Words = *BufferWords.emplace_back(std::make_unique<std::vector<uint32_t>>());
	Words.resize(NumElements * Stride / 4);
	std::uniform_real_distribution<float> Numbers(0.125f, 1.0f);
	for (uint32_t& Word : Words)
	{
		const float Value = Numbers(Random);
		std::memcpy(&Word, &Value, 4);
		Word = bUint ? uint32_t(Value * 8) : Word;
	}
	return {reinterpret_cast<uint8_t*>(Words.data()), uint32_t(Words.size() * 4), Stride, Storage};
}

float* FMadeArguments::GetTarget(size_t Target, int32_t X, int32_t Y)
{
	const FKernelMip& Mip = Targets[Target].Texture.Mips[0];
	return reinterpret_cast<float*>(Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * 16);
}

std::vector<double> FMadeArguments::ReadResults() const
{
	std::vector<double> Results;
	const auto AddWords = [&Results](const uint8_t* Data, size_t Bytes, bool bUint)
	{
		for (size_t At = 0; At + 4 <= Bytes; At += 4)
		{
			uint32_t Bits;
			std::memcpy(&Bits, Data + At, 4);
			float Value;
			std::memcpy(&Value, &Bits, 4);
			Results.push_back(bUint ? double(Bits) : double(Value));
		}
	};
	const auto AddTexture = [&](const FKernelTexture& Texture)
	{
		const FKernelMip& Mip = Texture.Mips[0];
		AddWords(Mip.Data, size_t(Mip.SlicePitch) * size_t(Mip.SizeZ),
			GetTexelStorageInfo(Texture.Storage).Kind == ETexelKind::Uint);
	};
	for (const FKernelTarget& Target : Targets)
	{
		AddTexture(Target.Texture);
	}
	for (const FKernelTexture& Texture : RWTextures)
	{
		AddTexture(Texture);
	}
	for (size_t i = 0; i < RWBuffers.size(); ++i)
	{
		AddWords(RWBuffers[i].Data, RWBuffers[i].SizeInBytes, Reflection.RWBuffers[i].Scalar != EShaderScalar::Float);
	}
	return Results;
}

std::string FMadeArguments::DescribeResult(size_t Index) const
{
	constexpr size_t PerTarget = size_t(GMadeSizeX) * size_t(GMadeSizeY) * 4;
	const std::string At = "number " + std::to_string(Index);
	if (Index >= PerTarget * (Targets.size() + RWTextures.size()))
	{
		return At;
	}
	const size_t Texel = Index % PerTarget / 4;
	return "pixel " + std::to_string(Texel % GMadeSizeX) + "," + std::to_string(Texel / GMadeSizeX) + " channel " +
		   std::to_string(Index % 4) + " of output " + std::to_string(Index / PerTarget);
}

} // namespace Drydock::Test
