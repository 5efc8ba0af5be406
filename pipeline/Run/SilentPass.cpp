// Compares a pass's output with its inputs, row by row.
#include "Run/SilentPass.h"

#include "PixelFormatConversion.h"
#include "RenderGraphPass.h"
#include "RenderGraphResources.h"
#include "Run/PassMember.h"
#include "Run/RunDump.h"
#include "ShaderParameterMetadata.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Shaders whose business it is to copy, or that do where a kernel is narrower than a pixel or there is no threshold.
 */
constexpr const char* Copying[] = {
	"FCopyRectPS", "FDownsamplePS", "FDownsampleCS", "FFilterPS", "FFilterCS", "FBloomSetupPS", "FBloomSetupCS"};

/** Words in names of parameters at 0 of which an effect does nothing. */
constexpr const char* Strengths[] = {
	"weight", "intensity", "strength", "amount", "opacity", "alpha", "blend", "factor", "scale", "radius", "mix"};

struct FInput
{
	std::string Name; // of the parameter
	FRDGTexture* Texture = nullptr;
};

const std::vector<FHlslMember>& GetMembers(const FRDGPass& Pass)
{
	static const std::vector<FHlslMember> None;
	return Pass.GetParameters() && Pass.GetParametersMetadata() ? Pass.GetParametersMetadata()->GetHlslMembers() : None;
}

std::vector<FInput> FindInputs(const FRDGPass& Pass)
{
	std::vector<FInput> Inputs;
	for (const FHlslMember& Member : GetMembers(Pass))
	{
		FRDGTexture* Texture = nullptr;
		if (Member.NumElements == 0 && Member.BaseType == UBMT_RDG_TEXTURE)
		{
			Texture = ReadMember<FRDGTexture*>(Pass, Member);
		}
		else if (Member.NumElements == 0 && Member.BaseType == UBMT_RDG_TEXTURE_SRV)
		{
			const FRDGTextureSRV* const View = ReadMember<FRDGTextureSRV*>(Pass, Member);
			Texture = View ? View->Desc.Texture : nullptr;
		}
		// A scene texture that no shader reads has no memory, and stays so.
		if (Texture && Texture->HasRHI() && Texture->GetRHI()->HasMemory())
		{
			Inputs.push_back({Member.CodeName, Texture});
		}
	}
	return Inputs;
}

/** The corners of the inputs' viewports and of the output's. */
std::vector<FIntPoint> FindCorners(const FRDGPass& Pass, FIntPoint Output)
{
	std::vector<FIntPoint> Corners{Output};
	for (const FHlslMember& Member : GetMembers(Pass))
	{
		if (Member.Name.ends_with("_ViewportMin") && Member.BaseType == UBMT_INT32 && Member.NumColumns == 2)
		{
			Corners.emplace_back(ReadMember<int32>(Pass, Member, 0), ReadMember<int32>(Pass, Member, 1));
		}
	}
	return Corners;
}

/** The rectangle of the texture that the pass drew, if it is known. */
FIntRect FindDrawn(const FRDGPass& Pass, const FPassCounters& Counters, const FRHITexture& Texture)
{
	const FIntRect Whole(FIntPoint(0, 0), Texture.GetSizeXY());
	for (const FTextureWrite& Write : Counters.Writes)
	{
		if (Write.Texture == &Texture && Write.Mip == 0)
		{
			return Write.Rect;
		}
	}
	FIntRect Rect = FindOutputRect(Pass, Texture.GetSizeXY()).Get(Whole);
	Rect.Clip(Whole);
	return Rect;
}

bool HaveSameTexels(FRHITexture& A, FIntPoint CornerA, FRHITexture& B, const FIntRect& RectB)
{
	const FIntPoint Size = A.GetSizeXY();
	const bool bFits =
		CornerA.X >= 0 && CornerA.Y >= 0 && CornerA.X + RectB.Width() <= Size.X && CornerA.Y + RectB.Height() <= Size.Y;
	const size_t Bytes = static_cast<size_t>(RectB.Width()) * GetTexelStorageInfo(A.GetStorage()).BytesPerTexel;
	for (int Y = 0; bFits && Y < RectB.Height(); ++Y)
	{
		if (std::memcmp(
				A.GetTexelToRead(CornerA.X, CornerA.Y + Y), B.GetTexelToRead(RectB.Min.X, RectB.Min.Y + Y), Bytes) != 0)
		{
			return false;
		}
	}
	return bFits;
}

bool IsOneColor(FRHITexture& Texture, const FIntRect& Rect)
{
	const size_t TexelBytes = GetTexelStorageInfo(Texture.GetStorage()).BytesPerTexel;
	const uint8* const First = Texture.GetTexelToRead(Rect.Min.X, Rect.Min.Y);
	for (int Y = Rect.Min.Y; Y < Rect.Max.Y; ++Y)
	{
		const uint8* const Row = Texture.GetTexelToRead(Rect.Min.X, Y);
		for (int X = 0; X < Rect.Width(); ++X)
		{
			if (std::memcmp(Row + static_cast<size_t>(X) * TexelBytes, First, TexelBytes) != 0)
			{
				return false;
			}
		}
	}
	return true;
}

/** Checks a name of the pass's own struct or one included in it. Deeper members belong to a part that may be off, or
 * to a viewport. */
bool IsStrength(std::string Name)
{
	if (std::ranges::count(Name, '.') > 1 || Name.find("Viewport") != std::string::npos)
	{
		return false;
	}
	Name = ToLowerCase(Name);
	return std::ranges::any_of(Strengths, [&Name](const char* Word) { return Name.find(Word) != std::string::npos; });
}

std::string FindReason(const FRDGPass& Pass, const std::vector<FInput>& Inputs, const FRDGTexture& Same)
{
	for (const FHlslMember& Member : GetMembers(Pass))
	{
		const size_t NumValues = size_t(std::max(Member.NumRows, 1u)) * std::max(Member.NumColumns, 1u);
		bool bZero = Member.BaseType == UBMT_FLOAT32 && Member.NumElements == 0 && IsStrength(Member.CodeName);
		for (size_t Index = 0; bZero && Index < NumValues; ++Index)
		{
			bZero = ReadMember<float>(Pass, Member, Index) == 0.0f;
		}
		if (bZero)
		{
			return Member.CodeName + " is 0";
		}
	}
	for (const FInput& Input : Inputs)
	{
		FRHITexture& Texture = *Input.Texture->GetRHI();
		const FIntRect Whole(FIntPoint(0, 0), Texture.GetSizeXY());
		if (Input.Texture != &Same && Whole.Area() > 1 && IsOneColor(Texture, Whole))
		{
			return Input.Name + " (" + Input.Texture->Name + ") is one value everywhere";
		}
	}
	return "its parameters leave every pixel as it is";
}

} // namespace

std::optional<FSilentPass> FindSilentPass(
	const FRDGPass& Pass, const FPassCounters& Counters, const std::vector<FRDGTexture*>& Written)
{
	const bool bCopies =
		std::ranges::any_of(Copying, [&Counters](const char* Shader) { return Counters.Shader == Shader; });
	if (Counters.Shader.empty() || bCopies)
	{
		return std::nullopt;
	}
	const std::vector<FInput> Inputs = FindInputs(Pass);
	for (FRDGTexture* const Output : Written)
	{
		FRHITexture& Texture = *Output->GetRHI();
		const FIntRect Drawn = FindDrawn(Pass, Counters, Texture);
		const bool bOneSlice = Texture.GetNumMips() == 1 && Texture.GetMipDimensions(0).Z <= 1;
		if (!bOneSlice || Drawn.Area() < 2)
		{
			continue;
		}
		for (const FInput& Input : Inputs)
		{
			FRHITexture& Read = *Input.Texture->GetRHI();
			const bool bComparable =
				Input.Texture != Output && Read.GetStorage() == Texture.GetStorage() && Read.GetMipDimensions(0).Z <= 1;
			for (const FIntPoint& Corner : bComparable ? FindCorners(Pass, Drawn.Min) : std::vector<FIntPoint>())
			{
				if (HaveSameTexels(Read, Corner, Texture, Drawn) && !IsOneColor(Texture, Drawn))
				{
					return FSilentPass{Input.Texture->Name, FindReason(Pass, Inputs, *Input.Texture)};
				}
			}
		}
	}
	return std::nullopt;
}

std::string DescribeSilentPass(const FSilentPass& Silent)
{
	return "it wrote the same values as it read from " + Silent.Input + ", bit for bit: " + Silent.Because;
}

} // namespace Drydock
