// Reads parameter structs, and scales textures down.
#include "Run/PassLook.h"

#include "RenderGraphPass.h"
#include "ShaderParameterMetadata.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

/** Elements of arrays, as rows of matrices, lie 16 bytes apart. */
constexpr uint32 ElementBytes = 16;

constexpr uint32 MaxElements = 16;

template<typename T>
T Read(const void* Parameters, uint32 Offset)
{
	T Value;
	std::memcpy(&Value, static_cast<const uint8*>(Parameters) + Offset, sizeof(T));
	return Value;
}

std::string NumberAt(const FHlslMember& Member, const void* Parameters, uint32 Offset)
{
	switch (Member.BaseType)
	{
	case UBMT_FLOAT32:
		return NumberText(Read<float>(Parameters, Offset));
	case UBMT_INT32:
		return std::to_string(Read<int32>(Parameters, Offset));
	default:
		return std::to_string(Read<uint32>(Parameters, Offset));
	}
}

std::string ReadConstant(const FHlslMember& Member, const void* Parameters)
{
	const uint32 NumRows = std::max(Member.NumRows, 1u) * std::max(std::min(Member.NumElements, MaxElements), 1u);
	std::string Text;
	for (uint32 Row = 0; Row < NumRows; ++Row)
	{
		Text += Row > 0 ? "; " : "";
		for (uint32 Column = 0; Column < std::max(Member.NumColumns, 1u); ++Column)
		{
			const uint32 Offset = Member.Offset + Row * ElementBytes + Column * 4;
			Text += (Column > 0 ? ", " : "") + NumberAt(Member, Parameters, Offset);
		}
	}
	return Text + (Member.NumElements > MaxElements ? "; ..." : "");
}

} // namespace

std::vector<FRunParameter> ReadPassParameters(const FRDGPass& Pass)
{
	std::vector<FRunParameter> Parameters;
	if (Pass.GetParametersMetadata() == nullptr)
	{
		return Parameters;
	}
	for (const FHlslMember& Member : Pass.GetParametersMetadata()->GetHlslMembers())
	{
		if (Member.IsConstant())
		{
			const std::string Array = Member.NumElements > 0 ? "[" + std::to_string(Member.NumElements) + "]" : "";
			Parameters.push_back({Member.Name, Member.Type + Array, ReadConstant(Member, Pass.GetParameters())});
		}
	}
	return Parameters;
}

FRunThumbnail MakeThumbnail(const std::string& Resource, FRHITexture& Texture, FIntRect Window)
{
	const FIntVector Size = Texture.GetMipDimensions(0);
	const FIntRect Whole(0, 0, Size.X, Size.Y);
	Window.Clip(Whole);
	const FPicture Picture(&Texture, Window.Area() > 0 ? Window : Whole,
		std::clamp(GPixelFormats[Texture.GetFormat()].NumComponents, 1, 4));
	const int Step = std::max({1, (Picture.Width + ThumbnailWidth - 1) / ThumbnailWidth,
		(Picture.Height + ThumbnailHeight - 1) / ThumbnailHeight});

	FRunThumbnail Thumbnail{Resource, FIntPoint(Size.X, Size.Y), {}};
	FImage& Image = Thumbnail.Image;
	Image.Width = (Picture.Width + Step - 1) / Step;
	Image.Height = (Picture.Height + Step - 1) / Step;
	Image.NumChannels = Picture.NumChannels;
	std::vector<float> Row(static_cast<size_t>(Picture.Width * Picture.NumChannels));
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		Picture.ReadRow(std::min(Y * Step + Step / 2, Picture.Height - 1), Row.data());
		for (int X = 0; X < Image.Width; ++X)
		{
			const int End = std::min((X + 1) * Step, Picture.Width);
			for (int Channel = 0; Channel < Image.NumChannels; ++Channel)
			{
				double Sum = 0.0;
				for (int Texel = X * Step; Texel < End; ++Texel)
				{
					Sum += Row[static_cast<size_t>(Texel * Image.NumChannels + Channel)];
				}
				Image.Values.push_back(Sum / (End - X * Step));
			}
		}
	}
	return Thumbnail;
}

} // namespace Drydock
