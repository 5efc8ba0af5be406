// Keeps a bit for each texel that nothing wrote, of textures that are not written as a whole.
#include "Run/UnwrittenWatch.h"

#include "KernelRerun.h"
#include "PixelFormatConversion.h"
#include "RHITexture.h"
#include "RenderGraphResources.h"
#include "Run/RunErrors.h"
#include "RunningCode.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr uint8_t Patterns[] = {0xA5, 0x5A}; // a texel that keeps both is not written
constexpr double Poison = 1000.0;

std::string GetPass(const FBoundShader& Shader)
{
	const FCodeOwner* const Owner = GetRunningCode();
	return Owner && !Owner->Pass.empty() ? Owner->Pass : Shader.Name;
}

/** Calls Function(X, Y) for the texels of a list of bits. */
template<typename TFunction>
void ForEachTexel(const std::vector<bool>& Bits, const FKernelMip& Mip, TFunction Function)
{
	for (size_t Index = 0; Index < Bits.size(); ++Index)
	{
		if (Bits[Index])
		{
			Function(int32_t(Index % size_t(Mip.SizeX)), int32_t(Index / size_t(Mip.SizeX)));
		}
	}
}

bool HoldsPattern(const uint8_t* Texel, int32_t Bytes, uint8_t Pattern)
{
	return std::all_of(Texel, Texel + Bytes, [Pattern](uint8_t Byte) { return Byte == Pattern; });
}

/** Whether any word of the row holds the pattern. */
template<typename TWord>
bool HasWord(const uint8_t* Row, int32_t Count, uint8_t Pattern)
{
	TWord Wanted;
	std::memset(&Wanted, Pattern, sizeof(Wanted));
	size_t Found = 0;
	for (int32_t Index = 0; Index < Count; ++Index)
	{
		TWord Word;
		std::memcpy(&Word, Row + size_t(Index) * sizeof(Word), sizeof(Word));
		Found += Word == Wanted;
	}
	return Found != 0;
}

bool HasPattern(const uint8_t* Row, int32_t Count, int32_t Bytes, uint8_t Pattern)
{
	return Bytes % 8 == 0   ? HasWord<uint64_t>(Row, Count * (Bytes / 8), Pattern)
		   : Bytes % 4 == 0 ? HasWord<uint32_t>(Row, Count * (Bytes / 4), Pattern)
		   : Bytes == 2     ? HasWord<uint16_t>(Row, Count, Pattern)
							: HasWord<uint8_t>(Row, Count, Pattern);
}

/** 1000 in every channel, as the storage holds it. */
void EncodePoison(const FKernelTexture& Texture, uint8_t* Texel)
{
	if (GetTexelStorageInfo(Texture.Storage).Kind == ETexelKind::Uint)
	{
		constexpr uint32_t Value[4] = {uint32_t(Poison), uint32_t(Poison), uint32_t(Poison), uint32_t(Poison)};
		EncodeTexel(Texture.Storage, Value, Texel);
		return;
	}
	constexpr double Value[4] = {Poison, Poison, Poison, Poison};
	EncodeTexel(Texture.Storage, Value, Texel);
}

std::string DescribeWriter(const FBoundShader& Shader, const FKernelTile& Whole)
{
	const int32_t* const Group = Shader.GetReflection().GroupSize;
	return Shader.GetReflection().Stage == EShaderStage::Compute
			   ? fmt::format("{}, of {} x {} groups of {} x {} threads", GetPass(Shader), Whole.MaxX / Group[0],
					 Whole.MaxY / Group[1], Group[0], Group[1])
			   : fmt::format("{}, which draws {} x {} at ({}, {})", GetPass(Shader), Whole.MaxX - Whole.MinX,
					 Whole.MaxY - Whole.MinY, Whole.MinX, Whole.MinY);
}

} // namespace

FUnwrittenWatch::~FUnwrittenWatch() = default;

bool FUnwrittenWatch::OnTextureMade(FRHITexture& Texture)
{
	Texture.EnsureMemory();
	const FTextureMipLayout& Layout = Texture.GetMipLayout(0);
	const uint8_t* const First = Texture.GetTexelToRead(0, 0);
	const uint8_t* const End = First + Texture.GetSizeInBytes();
	std::erase_if(Textures,
		[&](const auto& Known)
		{
			const FKernelMip& Mip = Known.second.Mip;
			return Mip.Data < End && First < Mip.Data + int64_t(Mip.RowPitch) * Mip.SizeY;
		});
	if (Texture.GetNumMips() > 1 || Layout.SizeZ > 1 || Texture.GetNumPlanes() > 1)
	{
		return true;
	}
	FTexture& New = Textures[First];
	New.Name = Texture.GetName().ToString().ToStdString();
	New.Texture = &Texture;
	New.Mip = {Texture.GetTexel(0, 0), Layout.SizeX, Layout.SizeY, 1, Layout.RowPitch, Layout.SlicePitch};
	New.TexelBytes = GetTexelStorageInfo(Texture.GetStorage()).BytesPerTexel;
	return true;
}

FUnwrittenWatch::FTexture* FUnwrittenWatch::Find(const FKernelTexture& Texture)
{
	const auto Known = Texture.NumMips > 0 ? Textures.find(Texture.Mips[0].Data) : Textures.end();
	return Known == Textures.end() ? nullptr : &Known->second;
}

/** A writer comes. */
void FUnwrittenWatch::Begin(FTexture& Texture, bool bForeign, const std::string& Writer)
{
	Texture.bForeign = Texture.bForeign || bForeign;
	Texture.Writer = Writer;
}

void FUnwrittenWatch::TakeRect(FTexture& Texture, const FIntRect& Rect)
{
	const FKernelMip& Mip = Texture.Mip;
	if (Texture.bWritten && Texture.NumUnwritten == 0)
	{
		return;
	}
	FIntRect Inside = Rect;
	Inside.Clip(FIntRect(0, 0, Mip.SizeX, Mip.SizeY));
	const auto Size = size_t(Mip.SizeX) * size_t(Mip.SizeY);
	if (size_t(Inside.Area()) == Size)
	{
		Texture.bWritten = true;
		Texture.NumUnwritten = 0;
		return;
	}
	if (!Texture.bWritten)
	{
		Texture.bWritten = true;
		Texture.Unwritten.assign(Size, true);
		Texture.NumUnwritten = Size;
	}
	for (int32_t y = Inside.Min.Y; y < Inside.Max.Y; ++y)
	{
		for (int32_t x = Inside.Min.X; x < Inside.Max.X; ++x)
		{
			auto&& bUnwritten = Texture.Unwritten[size_t(y) * size_t(Mip.SizeX) + size_t(x)];
			Texture.NumUnwritten -= bUnwritten;
			bUnwritten = false;
		}
	}
}

void FUnwrittenWatch::FillUnwritten(const FTexture& Texture, uint8_t Byte) const
{
	const FKernelMip& Mip = Texture.Mip;
	const auto Bytes = size_t(Texture.TexelBytes);
	if (!Texture.bWritten)
	{
		uint8_t Texel[32];
		std::memset(Texel, Byte, sizeof(Texel));
		Texture.Texture->FillRect(Texel, FIntRect(0, 0, Mip.SizeX, Mip.SizeY), 0);
		return;
	}
	Texture.Texture->Touch();
	ForEachTexel(Texture.Unwritten, Mip,
		[&](int32_t X, int32_t Y) { std::memset(GetTexelAddress(Mip, X, Y, Texture.TexelBytes), Byte, Bytes); });
}

void FUnwrittenWatch::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile&)
{
	const FShaderReflection& Reflection = Shader.GetReflection();
	for (const FKernelTexture& Read : Shader.Textures)
	{
		FTexture* const Texture = Find(Read);
		if (Texture)
		{
			Texture->bWritten = true; // by C++, or by nobody, which is reported as DD2040
		}
	}
	for (const FKernelTexture& Stored : Shader.RWTextures)
	{
		if (FTexture* const Texture = Find(Stored))
		{
			FillUnwritten(*Texture, Reflection.bLoadsStored ? 0 : Patterns[0]);
		}
	}
	for (int32_t Index = 0; Index < Args.NumTargets; ++Index)
	{
		const FKernelTarget& Target = Args.Targets[Index];
		FTexture* const Texture = Find(Target.Texture);
		if (Texture && (Target.bBlend || Target.WriteMask != 15))
		{
			FillUnwritten(*Texture, 0);
		}
		else if (Texture && Reflection.bUsesDiscard)
		{
			FillUnwritten(*Texture, Patterns[0]);
		}
	}
}

/** Finds the texels that still hold the pattern. If there are any, the kernel runs once more on another pattern, since
 * a value may look like the first. */
void FUnwrittenWatch::TakeWhatIsLeft(
	FTexture& Texture, const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole, size_t Written)
{
	const FKernelMip& Mip = Texture.Mip;
	const auto Size = size_t(Mip.SizeX) * size_t(Mip.SizeY);
	std::vector<bool> Left;
	if (Texture.bWritten && Texture.NumUnwritten == 0)
	{
		return;
	}
	for (int32_t y = 0; y < Mip.SizeY; ++y)
	{
		const uint8_t* const Row = Mip.Data + int64_t(y) * Mip.RowPitch;
		const bool bAny = HasPattern(Row, Mip.SizeX, Texture.TexelBytes, Patterns[0]);
		for (int32_t x = 0; bAny && x < Mip.SizeX; ++x)
		{
			const size_t Index = size_t(y) * size_t(Mip.SizeX) + size_t(x);
			const bool bMay = !Texture.bWritten || Texture.Unwritten[Index];
			if (bMay && HoldsPattern(Row + int64_t(x) * Texture.TexelBytes, Texture.TexelBytes, Patterns[0]))
			{
				Left.resize(Size);
				Left[Index] = true;
			}
		}
	}
	Texture.bWritten = true;
	Texture.NumUnwritten = 0;
	Texture.Unwritten.assign(Left.empty() ? 0 : Size, false);
	if (Left.empty())
	{
		return;
	}
	Texture.Texture->Touch();
	const FKernelRerun Rerun(Shader, Args, Whole);
	const FKernelMip& Again = Rerun.GetWritten()[Written].Mips[0];
	const auto Bytes = size_t(Texture.TexelBytes);
	ForEachTexel(Left, Mip,
		[&](int32_t X, int32_t Y)
		{ std::memset(GetTexelAddress(Again, X, Y, Texture.TexelBytes), Patterns[1], Bytes); });
	Rerun.Run();
	ForEachTexel(Left, Mip,
		[&](int32_t X, int32_t Y)
		{
			if (HoldsPattern(GetTexelAddress(Again, X, Y, Texture.TexelBytes), Texture.TexelBytes, Patterns[1]))
			{
				Texture.Unwritten[size_t(Y) * size_t(Mip.SizeX) + size_t(X)] = true;
				++Texture.NumUnwritten;
				std::memset(GetTexelAddress(Mip, X, Y, Texture.TexelBytes), 0, Bytes);
			}
		});
}

void FUnwrittenWatch::AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	const FShaderReflection& Reflection = Shader.GetReflection();
	const FIntRect Drawn(Whole.MinX, Whole.MinY, Whole.MaxX, Whole.MaxY);
	for (int32_t Index = 0; Index < Args.NumTargets; ++Index)
	{
		const FKernelTarget& Target = Args.Targets[Index];
		if (FTexture* const Texture = Find(Target.Texture))
		{
			DrawnHere.insert(Texture->Mip.Data);
			Begin(*Texture, IsForeignCodeRunning(), DescribeWriter(Shader, Whole));
			const bool bPattern = Reflection.bUsesDiscard && !Target.bBlend && Target.WriteMask == 15;
			bPattern ? TakeWhatIsLeft(*Texture, Shader, Args, Whole, size_t(Index)) : TakeRect(*Texture, Drawn);
		}
	}
	for (size_t Slot = 0; Slot < Shader.RWTextures.size(); ++Slot)
	{
		if (FTexture* const Texture = Find(Shader.RWTextures[Slot]))
		{
			DrawnHere.insert(Texture->Mip.Data);
			Begin(*Texture, IsForeignCodeRunning(), DescribeWriter(Shader, Whole));
			if (Reflection.bLoadsStored || Args.NumTargets > 0)
			{
				TakeRect(*Texture, FIntRect(0, 0, Texture->Mip.SizeX, Texture->Mip.SizeY));
			}
			else
			{
				TakeWhatIsLeft(*Texture, Shader, Args, Whole, Slot);
			}
		}
	}
	for (size_t Slot = 0; Slot < Shader.Textures.size(); ++Slot)
	{
		const FTexture* const Texture = Find(Shader.Textures[Slot]);
		if (Texture && Texture->NumUnwritten > 0 && (Texture->bForeign || IsForeignCodeRunning()))
		{
			AskReader(Shader, Args, Whole, Slot);
		}
	}
	ForgetWhole();
}

void FUnwrittenWatch::ForgetWhole()
{
	std::erase_if(Textures, [](const auto& Known) { return Known.second.bWritten && Known.second.NumUnwritten == 0; });
}

void FUnwrittenWatch::AskReader(
	const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole, size_t Slot)
{
	const FTexture& Texture = *Find(Shader.Textures[Slot]);
	const std::string Pass = GetPass(Shader);
	if (!Reported.insert({Texture.Name, Pass}).second)
	{
		return;
	}
	const FKernelRerun Clean(Shader, Args, Whole);
	FKernelRerun Poisoned(Shader, Args, Whole);
	FOwnTexture& Input = Poisoned.OwnInput(Slot);
	uint8_t Texel[32] = {};
	EncodePoison(Input.Get(), Texel);
	FIntPoint First(-1, -1);
	ForEachTexel(Texture.Unwritten, Texture.Mip,
		[&](int32_t X, int32_t Y)
		{
			First = First.X < 0 ? FIntPoint(X, Y) : First;
			std::memcpy(GetTexelAddress(Input.GetMip(), X, Y, Texture.TexelBytes), Texel, size_t(Texture.TexelBytes));
		});
	Clean.Run();
	Poisoned.Run();
	uint64_t NumChanged = 0;
	FIntPoint FirstChanged(0, 0);
	for (size_t Index = 0; Index < Clean.GetWritten().size(); ++Index)
	{
		const FKernelTexture& A = Clean.GetWritten()[Index];
		const FKernelMip& B = Poisoned.GetWritten()[Index].Mips[0];
		const int32_t Bytes = GetTexelStorageInfo(A.Storage).BytesPerTexel;
		for (int32_t y = 0; y < B.SizeY; ++y)
		{
			for (int32_t x = 0; x < B.SizeX; ++x)
			{
				if (std::memcmp(
						GetTexelAddress(A.Mips[0], x, y, Bytes), GetTexelAddress(B, x, y, Bytes), size_t(Bytes)) != 0)
				{
					FirstChanged = NumChanged++ == 0 ? FIntPoint(x, y) : FirstChanged;
				}
			}
		}
	}
	if (NumChanged > 0)
	{
		Diagnostics.push_back({.Severity = ESeverity::Warning,
			.Code = WarnUnwrittenRead,
			.Message =
				fmt::format("the pass reads texels of {} that nothing wrote: {} of {} x {}, the first at ({}, {}); {} "
							"pixels that it writes depend on them, the first at ({}, {}). Its writer is {}. They "
							"are 0 here, and anything on a GPU",
					Texture.Name, Texture.NumUnwritten, Texture.Mip.SizeX, Texture.Mip.SizeY, First.X, First.Y,
					NumChanged, FirstChanged.X, FirstChanged.Y, Texture.Writer),
			.Where = "pass " + Pass + ", " + Shader.Name});
	}
}

void FUnwrittenWatch::OnPassExecuted(const std::string& Pass, bool bForeign, const FPassCounters& Counters,
	const std::vector<FRDGTexture*>& WrittenTextures)
{
	const auto FindKnown = [this](const FRHITexture* Texture)
	{
		return Texture && Texture->HasMemory() ? Textures.find(const_cast<FRHITexture*>(Texture)->GetTexelToRead(0, 0))
											   : Textures.end();
	};
	for (const FTextureWrite& Write : Counters.Writes)
	{
		const auto Known = Write.Mip == 0 ? FindKnown(Write.Texture) : Textures.end();
		if (Known != Textures.end() && DrawnHere.insert(Known->first).second)
		{
			Begin(Known->second, bForeign, Pass);
			TakeRect(Known->second, Write.Rect);
		}
	}
	for (const FRDGTexture* const Written : WrittenTextures)
	{
		const auto Known = FindKnown(Written->GetRHI());
		if (Known != Textures.end() && !DrawnHere.contains(Known->first))
		{
			Textures.erase(Known); // C++ wrote it, and nobody saw which texels
		}
	}
	DrawnHere.clear();
	ForgetWhole();
}

} // namespace Drydock
