// Turns final pictures into bytes, and keeps those that somebody may still ask for.
#include "Live/LivePictures.h"

#include "Picture/Preview.h"
#include "TileExecutor.h"

#include <Imath/half.h>

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr size_t NumLast = 3;

size_t GetShrunk(int Size, int Step)
{
	return static_cast<size_t>((Size + Step - 1) / Step);
}

/** The rows of the small picture that belong to these of the whole one; First: a multiple of Step. */
void ShrinkRows(const FLivePicture& Picture, int Step, int First, int End, std::string& Small)
{
	const int Width = Picture.Final.Width;
	char* To = Small.data() + static_cast<size_t>(First / Step) * GetShrunk(Width, Step) * 4;
	for (int Top = First; Top < End; Top += Step)
	{
		for (int Left = 0; Left < Width; Left += Step)
		{
			const int Right = std::min(Left + Step, Width), Bottom = std::min(Top + Step, End);
			uint32_t RedAndBlue = 0, GreenAndAlpha = 0; // two sums of 16 bits each
			for (int Y = Top; Y < Bottom; ++Y)
			{
				const char* From =
					Picture.Codes.data() +
					(static_cast<size_t>(Y) * static_cast<size_t>(Width) + static_cast<size_t>(Left)) * 4;
				for (int X = Left; X < Right; ++X, From += 4)
				{
					uint32_t Texel = 0;
					std::memcpy(&Texel, From, sizeof(Texel));
					RedAndBlue += Texel & 0xff00ff;
					GreenAndAlpha += (Texel >> 8) & 0xff00ff;
				}
			}
			const auto Count = static_cast<uint32_t>((Right - Left) * (Bottom - Top));
			for (const uint32_t Sum :
				{RedAndBlue & 0xffff, GreenAndAlpha & 0xffff, RedAndBlue >> 16, GreenAndAlpha >> 16})
			{
				*To++ = static_cast<char>((Sum + Count / 2) / Count);
			}
		}
	}
}

} // namespace

std::string ShrinkCodes(const FLivePicture& Picture, int Step)
{
	const int Width = Picture.Final.Width, Height = Picture.Final.Height;
	std::string Small(GetShrunk(Width, Step) * GetShrunk(Height, Step) * 4, '\0');
	ShrinkRows(Picture, Step, 0, Height, Small);
	return Small;
}

std::string MakeFloatBytes(const FPicture& Picture, bool bAsFile)
{
	const bool bHalf = bAsFile && Picture.FitsHalf();
	const size_t Width = static_cast<size_t>(Picture.Width);
	const size_t NumChannels = static_cast<size_t>(Picture.NumChannels);
	std::string Bytes(Width * static_cast<size_t>(Picture.Height) * 4 * sizeof(float), '\0');
	float* To = reinterpret_cast<float*>(Bytes.data());
	std::vector<float> Row(Width * NumChannels);
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		for (size_t X = 0; X < Width; ++X, To += 4)
		{
			To[3] = 1.0f;
			for (size_t Channel = 0; Channel < NumChannels; ++Channel)
			{
				const float Value = Row[X * NumChannels + Channel];
				To[Channel] = bHalf ? imath_half_to_float(imath_float_to_half(Value)) : Value;
			}
		}
	}
	return Bytes;
}

void FLivePictures::Add(uint64_t Revision, const FRunResult& Result)
{
	const std::shared_ptr<FLivePicture> Made(new FLivePicture,
		[this](FLivePicture* Picture)
		{
			const std::lock_guard Lock(Mutex);
			Spare = std::move(Picture->Codes);
			delete Picture;
		});
	{
		const std::lock_guard Lock(Mutex);
		Last.resize(std::min(Last.size(), NumLast - 1));
		Made->Codes = std::move(Spare); // new memory costs milliseconds
	}
	Made->Revision = Revision;
	Made->Final = Result.Final;
	const FPicture& Final = Result.Final;
	const size_t Width = static_cast<size_t>(Final.Width);
	Made->Codes.resize(Width * static_cast<size_t>(Final.Height) * 4);
	Made->Step = Step;
	Made->Small.resize(
		Made->Step > 1 ? GetShrunk(Final.Width, Made->Step) * GetShrunk(Final.Height, Made->Step) * 4 : 0);
	const int32 Rows = Made->Step * std::max(16 / Made->Step, 1);
	ForEachTile(FKernelTile{0, 0, 0, 1, Final.Height, 1}, FIntPoint(1, Rows),
		[&](const FKernelTile& Tile)
		{
			std::vector<float> Row(Width * static_cast<size_t>(Final.NumChannels));
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				uint8_t* const To = reinterpret_cast<uint8_t*>(Made->Codes.data()) + static_cast<size_t>(Y) * Width * 4;
				Final.ReadRow(Y, Row.data());
				MakeDisplayRow(Row.data(), Final.Width, Final.NumChannels, Result.OutputDevice, To, 4);
				for (size_t X = 0; X < Width; ++X)
				{
					To[X * 4 + 3] = 255;
				}
			}
			if (Made->Step > 1)
			{
				ShrinkRows(*Made, Made->Step, Tile.MinY, Tile.MaxY, Made->Small);
			}
		});
	const std::lock_guard Lock(Mutex);
	Kept.emplace("start", Made);
	Last.push_front(Made);
}

void FLivePictures::Keep(const std::string& Name)
{
	const std::lock_guard Lock(Mutex);
	if (!Last.empty())
	{
		Kept[Name] = Last.front();
	}
}

void FLivePictures::Forget(const std::string& Name)
{
	const std::lock_guard Lock(Mutex);
	Kept.erase(Name);
}

FLivePictures::FHandle FLivePictures::Find(const std::string& Name) const
{
	const std::lock_guard Lock(Mutex);
	if (Name == "now")
	{
		return Last.empty() ? nullptr : Last.front();
	}
	if (const auto Found = Kept.find(Name); Found != Kept.end())
	{
		return Found->second;
	}
	for (const FHandle& Picture : Last)
	{
		if (std::to_string(Picture->Revision) == Name)
		{
			return Picture;
		}
	}
	return nullptr;
}

} // namespace Drydock
