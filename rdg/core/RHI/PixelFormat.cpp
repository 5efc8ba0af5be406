// The table of pixel formats. Source: engine PixelFormat.h, RHI.cpp (names, component counts).
#include "PixelFormat.h"

#include "PixelFormatConversion.h"

#include <strings.h>

namespace
{

using Drydock::ETexelStorage;

struct FFormatRow
{
	EPixelFormat Format;
	const TCHAR* Name; // with "PF_"
	ETexelStorage Storage;
};

constexpr FFormatRow GFormatRows[] = {
	{PF_A32B32G32R32F, TEXT("PF_A32B32G32R32F"), ETexelStorage::RGBA32_FLOAT},
	{PF_B8G8R8A8, TEXT("PF_B8G8R8A8"), ETexelStorage::BGRA8_UNORM},
	{PF_G8, TEXT("PF_G8"), ETexelStorage::R8_UNORM},
	{PF_G16, TEXT("PF_G16"), ETexelStorage::R16_UNORM},
	{PF_FloatRGB, TEXT("PF_FloatRGB"), ETexelStorage::R11G11B10_FLOAT},
	{PF_FloatRGBA, TEXT("PF_FloatRGBA"), ETexelStorage::RGBA16_FLOAT},
	{PF_DepthStencil, TEXT("PF_DepthStencil"), ETexelStorage::R32_FLOAT},
	{PF_ShadowDepth, TEXT("PF_ShadowDepth"), ETexelStorage::R32_FLOAT},
	{PF_R32_FLOAT, TEXT("PF_R32_FLOAT"), ETexelStorage::R32_FLOAT},
	{PF_G16R16, TEXT("PF_G16R16"), ETexelStorage::RG16_UNORM},
	{PF_G16R16F, TEXT("PF_G16R16F"), ETexelStorage::RG16_FLOAT},
	{PF_G16R16F_FILTER, TEXT("PF_G16R16F_FILTER"), ETexelStorage::RG16_FLOAT},
	{PF_G32R32F, TEXT("PF_G32R32F"), ETexelStorage::RG32_FLOAT},
	{PF_A2B10G10R10, TEXT("PF_A2B10G10R10"), ETexelStorage::RGB10A2_UNORM},
	{PF_A16B16G16R16, TEXT("PF_A16B16G16R16"), ETexelStorage::RGBA16_UNORM},
	{PF_D24, TEXT("PF_D24"), ETexelStorage::R32_FLOAT},
	{PF_R16F, TEXT("PF_R16F"), ETexelStorage::R16_FLOAT},
	{PF_R16F_FILTER, TEXT("PF_R16F_FILTER"), ETexelStorage::R16_FLOAT},
	{PF_FloatR11G11B10, TEXT("PF_FloatR11G11B10"), ETexelStorage::R11G11B10_FLOAT},
	{PF_R32_UINT, TEXT("PF_R32_UINT"), ETexelStorage::R32_UINT},
	{PF_R32_SINT, TEXT("PF_R32_SINT"), ETexelStorage::R32_SINT},
	{PF_R16_UINT, TEXT("PF_R16_UINT"), ETexelStorage::R16_UINT},
	{PF_R16G16B16A16_UINT, TEXT("PF_R16G16B16A16_UINT"), ETexelStorage::RGBA16_UINT},
	{PF_R8G8B8A8, TEXT("PF_R8G8B8A8"), ETexelStorage::RGBA8_UNORM},
	{PF_R8G8, TEXT("PF_R8G8"), ETexelStorage::RG8_UNORM},
	{PF_X24_G8, TEXT("PF_X24_G8"), ETexelStorage::R8_UINT},
	{PF_R32G32B32A32_UINT, TEXT("PF_R32G32B32A32_UINT"), ETexelStorage::RGBA32_UINT},
	{PF_R16G16_UINT, TEXT("PF_R16G16_UINT"), ETexelStorage::RG16_UINT},
	{PF_R8_UINT, TEXT("PF_R8_UINT"), ETexelStorage::R8_UINT},
	{PF_L8, TEXT("PF_L8"), ETexelStorage::R8_UNORM},
	{PF_R8G8B8A8_UINT, TEXT("PF_R8G8B8A8_UINT"), ETexelStorage::RGBA8_UINT},
	{PF_R16G16B16A16_UNORM, TEXT("PF_R16G16B16A16_UNORM"), ETexelStorage::RGBA16_UNORM},
	{PF_R32G32_UINT, TEXT("PF_R32G32_UINT"), ETexelStorage::RG32_UINT},
	{PF_R8, TEXT("PF_R8"), ETexelStorage::R8_UNORM},
	{PF_R8G8_UINT, TEXT("PF_R8G8_UINT"), ETexelStorage::RG8_UINT},
	{PF_R32G32B32F, TEXT("PF_R32G32B32F"), ETexelStorage::RGB32_FLOAT},
};

constexpr std::array<FPixelFormatInfo, PF_MAX> MakeFormatTable()
{
	std::array<FPixelFormatInfo, PF_MAX> Table{};
	for (const FFormatRow& Row : GFormatRows)
	{
		const Drydock::FTexelStorageInfo& Storage = Drydock::GetTexelStorageInfo(Row.Storage);
		FPixelFormatInfo& Info = Table[Row.Format];
		Info.Name = Row.Name + 3;
		Info.BlockBytes = Storage.BytesPerTexel;
		Info.NumComponents = Storage.NumChannels;
		Info.Supported = true;
		Info.Capabilities = EPixelFormatCapabilities::AllFlags;
		Info.UnrealFormat = Row.Format;
		Info.Storage = Row.Storage;
	}
	return Table;
}

const FFormatRow* FindFormatRow(EPixelFormat Format)
{
	for (const FFormatRow& Row : GFormatRows)
	{
		if (Row.Format == Format)
		{
			return &Row;
		}
	}
	return nullptr;
}

} // namespace

constinit const std::array<FPixelFormatInfo, PF_MAX> GPixelFormats = MakeFormatTable();

const TCHAR* GetPixelFormatString(EPixelFormat Format)
{
	const FFormatRow* Row = FindFormatRow(Format);
	return Row ? Row->Name : TEXT("PF_unknown");
}

EPixelFormat GetPixelFormatFromString(const TCHAR* Name)
{
	for (const FFormatRow& Row : GFormatRows)
	{
		if (strcasecmp(Row.Name, Name) == 0 || strcasecmp(Row.Name + 3, Name) == 0)
		{
			return Row.Format;
		}
	}
	return PF_Unknown;
}

bool IsInteger(EPixelFormat Format)
{
	const FFormatRow* Row = FindFormatRow(Format);
	return Row && Drydock::GetTexelStorageInfo(Row->Storage).Kind == Drydock::ETexelKind::Uint;
}

bool IsFloatFormat(EPixelFormat Format)
{
	const FFormatRow* Row = FindFormatRow(Format);
	return Row && Drydock::GetTexelStorageInfo(Row->Storage).Kind == Drydock::ETexelKind::Float;
}
