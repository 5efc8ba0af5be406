// Turns final pictures into bytes, and keeps those that somebody may still ask for.
#include "Live/LivePictures.h"

#include "Picture/Preview.h"
#include "TileExecutor.h"

#include <Imath/half.h>

namespace Drydock
{

namespace
{

constexpr size_t NumLast = 3;

} // namespace

std::shared_ptr<const FLivePicture> MakeLivePicture(uint64_t Revision, const FRunResult& Result)
{
	const auto Made = std::make_shared<FLivePicture>();
	Made->Revision = Revision;
	Made->Final = Result.Final;
	const FPicture& Final = Result.Final;
	const size_t Width = static_cast<size_t>(Final.Width);
	Made->Codes.assign(Width * static_cast<size_t>(Final.Height) * 4, '\xff');
	constexpr int32 Rows = 16;
	ForEachTile(FKernelTile{0, 0, 0, 1, Final.Height, 1}, FIntPoint(1, Rows),
		[&](const FKernelTile& Tile)
		{
			std::vector<float> Row(Width * static_cast<size_t>(Final.NumChannels));
			for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
			{
				uint8_t* const To = reinterpret_cast<uint8_t*>(Made->Codes.data()) + static_cast<size_t>(Y) * Width * 4;
				Final.ReadRow(Y, Row.data());
				MakeDisplayRow(Row.data(), Final.Width, Final.NumChannels, Result.OutputDevice, To, 4);
			}
		});
	return Made;
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

void FLivePictures::Add(const FHandle& Picture)
{
	const std::lock_guard Lock(Mutex);
	Kept.emplace("start", Picture);
	Last.push_front(Picture);
	if (Last.size() > NumLast)
	{
		Last.pop_back();
	}
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
