// Compares the passes of two frames while the second one runs.
#include "Prove/PassRecord.h"

#include "RHITexture.h"
#include "RenderGraphPass.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr double OneStep = 1.01 / 255; // of a display-encoded value in 8 bits; of larger ones that share
constexpr uint64_t SharePerMille = 1000;

std::vector<double> TakePixel(const std::vector<double>& Row, int X, int NumChannels)
{
	const auto First = Row.begin() + static_cast<std::ptrdiff_t>(X) * NumChannels;
	return {First, First + NumChannels};
}

/** True if the pixel looks like memory that was filled before anything wrote it: 0 in the base, one number in all
 * channels of the other frame. */
bool LooksUnwritten(const FPixelDifference& Pixel)
{
	const bool bZero = std::ranges::all_of(Pixel.Base, [](double Value) { return Value == 0.0; });
	const bool bFilled = std::ranges::all_of(
		Pixel.Other, [&](double Value) { return std::memcmp(&Value, &Pixel.Other[0], sizeof(Value)) == 0; });
	return bZero && bFilled;
}

struct FComparison
{
	bool bExact = true;          // every difference counts, else those above a step
	bool bSkipUnwritten = false; // pixels that look as if nothing wrote them do not
	double Scale = 1.0;          // this multiple is the same value
};

struct FCounted
{
	std::optional<FPixelDifference> First; // that counts
	uint64_t NumValues = 0;                // that differ at all
	uint64_t NumUnwritten = 0;             // pixels that were skipped
	FIntPoint Unwritten = FIntPoint(0, 0); // the first of them
};

FCounted CountDifferences(const FPicture& Base, const FPicture& Other, const FComparison& Comparison)
{
	check(Base.Width == Other.Width && Base.Height == Other.Height && Base.NumChannels == Other.NumChannels);
	const int NumChannels = Base.NumChannels;
	std::vector<double> RowA(static_cast<size_t>(Base.Width) * static_cast<size_t>(NumChannels)), RowB(RowA.size());
	FCounted Counted;
	for (int Y = 0; Y < Base.Height; ++Y)
	{
		Base.ReadRow(Y, RowA.data());
		Other.ReadRow(Y, RowB.data());
		if (std::memcmp(RowA.data(), RowB.data(), RowA.size() * sizeof(double)) == 0)
		{
			continue;
		}
		for (int X = 0; X < Base.Width; ++X)
		{
			bool bDiffers = false;
			for (int Channel = 0; Channel < NumChannels; ++Channel)
			{
				const size_t Index = static_cast<size_t>(X) * static_cast<size_t>(NumChannels) + size_t(Channel);
				const bool bSame = std::memcmp(&RowA[Index], &RowB[Index], sizeof(double)) == 0 ||
								   (Comparison.Scale != 1.0 && RowA[Index] * Comparison.Scale == RowB[Index]);
				Counted.NumValues += bSame ? 0 : 1;
				bDiffers =
					bDiffers ||
					!(bSame || (!Comparison.bExact && (AreClose(RowA[Index], RowB[Index]) ||
														  AreClose(RowA[Index] * Comparison.Scale, RowB[Index]))));
			}
			FPixelDifference Pixel{X, Y, {}, {}, 0};
			if (bDiffers)
			{
				Pixel.Base = TakePixel(RowA, X, NumChannels);
				Pixel.Other = TakePixel(RowB, X, NumChannels);
				bDiffers = !Comparison.bSkipUnwritten || !LooksUnwritten(Pixel);
				if (!bDiffers && Counted.NumUnwritten++ == 0)
				{
					Counted.Unwritten = FIntPoint(X, Y);
				}
			}
			if (bDiffers && !Counted.First)
			{
				Counted.First = std::move(Pixel);
			}
			if (bDiffers)
			{
				++Counted.First->NumPixels;
			}
		}
	}
	return Counted;
}

/** Copies the drawn part of the mip, as it is now. */
FPicture CopyWindow(const FWrittenMip& Mip)
{
	const FPicture Whole = FPicture::Copy(*Mip.Texture, Mip.Mip);
	FIntRect Window = Mip.Window;
	Window.Clip(FIntRect(0, 0, Whole.Width, Whole.Height));
	return Window.Area() > 0 ? Whole.Crop(Window) : FPicture();
}

} // namespace

bool AreClose(double A, double B)
{
	const double Size = std::max({1.0, std::abs(A), std::abs(B)});
	return std::memcmp(&A, &B, sizeof(A)) == 0 || std::abs(A - B) <= OneStep * Size;
}

std::string FormatSize(const FPicture& Picture)
{
	return std::to_string(Picture.Width) + " x " + std::to_string(Picture.Height);
}

std::optional<FPixelDifference> ComparePixels(const FPicture& Base, const FPicture& Other, EAlike Alike)
{
	const bool bExact = Alike == EAlike::SameBits;
	FCounted Counted = CountDifferences(Base, Other, {.bExact = bExact});
	const uint64_t NumValues = uint64_t(Base.Width) * uint64_t(Base.Height) * uint64_t(Base.NumChannels);
	if (!bExact && !Counted.First && Counted.NumValues * SharePerMille > NumValues)
	{
		Counted = CountDifferences(Base, Other, {});
	}
	return Counted.First;
}

FPassRecord::FPassRecord(EAlike InAlike, bool bInClobbered, double InScale)
	: Alike(InAlike)
	, bClobbered(bInClobbered)
	, Scale(InScale)
{
}

/** Counts the earlier passes of the same name: by the compiled graph if it is known, because one of two frames may
 * leave out some. */
int FPassRecord::CountEarlier(const FPassWrites& Writes, std::map<std::string, int>& Executed)
{
	const std::string Name = Writes.Pass.GetName();
	const int NumExecuted = Executed[Name]++;
	if (Writes.Graph.Passes.empty())
	{
		return NumExecuted;
	}
	return static_cast<int>(std::count_if(Writes.Graph.Passes.begin(),
		Writes.Graph.Passes.begin() + std::min<std::ptrdiff_t>(Writes.PassIndex, std::ssize(Writes.Graph.Passes)),
		[&Name](const FRDGCompiledPass& Pass) { return Pass.Name == Name; }));
}

void FPassRecord::Keep(const FPassWrites& Writes)
{
	const bool bRaster = EnumHasAnyFlags(Writes.Pass.GetFlags(), ERDGPassFlags::Raster);
	const int Number = CountEarlier(Writes, KeptByName);
	for (const FWrittenMip& Mip : Writes.Mips)
	{
		FPicture Window = CopyWindow(Mip);
		if (Window.Width > 0)
		{
			Kept[{Writes.Pass.GetName(), Number, Mip.Resource, Mip.Mip}] = {std::move(Window), bRaster};
		}
	}
}

void FPassRecord::Compare(const FPassWrites& Writes)
{
	if (Difference)
	{
		return;
	}
	const int Number = CountEarlier(Writes, ComparedByName);
	std::map<std::string, std::string> Unwritten; // by texture: what a part of the threads left
	for (const FWrittenMip& Mip : Writes.Mips)
	{
		const auto Known = Kept.find({Writes.Pass.GetName(), Number, Mip.Resource, Mip.Mip});
		const FPicture Window = CopyWindow(Mip);
		if (Known == Kept.end() || Window.Width == 0)
		{
			continue; // it runs in this frame alone
		}
		const FPicture& Base = Known->second.Picture;
		FCounted Counted;
		FFirstDifference Found{Writes.Pass.GetName(), Writes.Pass.GetShader(), Writes.Pass.GetOwner().Plugin,
			Mip.Resource, Mip.Mip, "", std::nullopt, {}};
		if (Base.Width != Window.Width || Base.Height != Window.Height || Base.NumChannels != Window.NumChannels)
		{
			// The size counts only if the texture is drawn as a whole and was empty before.
			Found.Sizes =
				Known->second.bRaster && !Mip.bExternal ? FormatSize(Base) + ", and " + FormatSize(Window) : "";
		}
		else
		{
			Counted = CountDifferences(Base, Window,
				{.bExact = Alike == EAlike::SameBits,
					.bSkipUnwritten = bClobbered && !Known->second.bRaster,
					.Scale = Scale});
			Found.Pixel = Counted.First;
		}
		if (Found.Pixel || !Found.Sizes.empty())
		{
			Difference = std::move(Found);
			NotePartlyDrawn(Writes);
			return;
		}
		if (Counted.NumUnwritten > 0)
		{
			Unwritten[Mip.Resource] = "by pass " + Found.Pass + ", all but " + std::to_string(Counted.NumUnwritten) +
									  " pixels (the first is (" + std::to_string(Counted.Unwritten.X) + ", " +
									  std::to_string(Counted.Unwritten.Y) + "))";
		}
	}
	for (const FWrittenMip& Mip : Writes.Mips)
	{
		const FIntPoint Size = Mip.Texture->GetSizeXY();
		const bool bWhole = Mip.Mip > 0 || Mip.Window.Area() >= Size.X * Size.Y;
		Partly[Mip.Resource] = bWhole
								   ? Unwritten[Mip.Resource]
								   : std::to_string(Mip.Window.Width()) + " x " + std::to_string(Mip.Window.Height()) +
										 " of " + std::to_string(Size.X) + " x " + std::to_string(Size.Y);
	}
}

void FPassRecord::NotePartlyDrawn(const FPassWrites& Writes)
{
	if (static_cast<size_t>(Writes.PassIndex) >= Writes.Graph.Passes.size())
	{
		return;
	}
	for (const FRDGUse& Use : Writes.Graph.Passes[static_cast<size_t>(Writes.PassIndex)].Uses)
	{
		const FRDGCompiledResource& Resource = Writes.Graph.Resources[static_cast<size_t>(Use.Resource)];
		if (!Use.IsRead() || Resource.bExternal || Resource.Kind != ERDGResourceKind::Texture)
		{
			continue;
		}
		const auto Known = Partly.find(Resource.Name);
		const std::string What = Known == Partly.end() ? "nothing" : Known->second;
		const std::string Text = Resource.Name + ": " + What;
		if (!What.empty() && std::ranges::find(Difference->PartlyDrawn, Text) == Difference->PartlyDrawn.end())
		{
			Difference->PartlyDrawn.push_back(Text);
		}
	}
}

} // namespace Drydock
