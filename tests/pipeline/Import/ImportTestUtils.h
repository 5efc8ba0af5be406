// Frames as other programs write them: EXR files of any layers, types, parts, windows and tiles, in a folder of the
// test's own.
#pragma once

#include <Imath/half.h>
#include <OpenImageIO/imageio.h>

#include "Import/ImportGuess.h"
#include "Picture/ImageFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <unistd.h>
#include <vector>

namespace ImportTest
{

using FValue = std::function<double(int X, int Y)>;

struct FChannel
{
	std::string Name;
	FValue Value;
	OIIO::TypeDesc Type = OIIO::TypeDesc::FLOAT;
};

/** One part of a file. */
struct FPart
{
	int Width = 4;
	int Height = 3;
	std::vector<FChannel> Channels;
	std::string Name = {}; // of the part
	int X = 0;             // of the data window in the picture
	int Y = 0;
	int FullWidth = 0; // 0: as the data
	int FullHeight = 0;
	bool bTiled = false;
	std::map<std::string, std::string> Attributes = {};
	std::vector<float> Chromaticities = {};
};

inline FValue Constant(double Value)
{
	return [Value](int, int)
	{
		return Value;
	};
}

/** "Layer.R", "Layer.G", ... of one value each. */
inline std::vector<FChannel> MakeLayer(const std::string& Layer, const std::string& Components,
	std::vector<double> Values, OIIO::TypeDesc Type = OIIO::TypeDesc::HALF)
{
	std::vector<FChannel> Channels;
	for (size_t Index = 0; Index < Components.size(); ++Index)
	{
		Channels.push_back({(Layer.empty() ? "" : Layer + ".") + Components[Index],
			Constant(Values[std::min(Index, Values.size() - 1)]), Type});
	}
	return Channels;
}

inline std::vector<FChannel> Join(std::initializer_list<std::vector<FChannel>> Layers)
{
	std::vector<FChannel> All;
	for (const std::vector<FChannel>& Layer : Layers)
	{
		All.insert(All.end(), Layer.begin(), Layer.end());
	}
	return All;
}

inline OIIO::ImageSpec MakeSpec(const FPart& Part)
{
	OIIO::ImageSpec Spec(Part.Width, Part.Height, static_cast<int>(Part.Channels.size()), OIIO::TypeDesc::FLOAT);
	Spec.channelnames.clear();
	for (const FChannel& Channel : Part.Channels)
	{
		Spec.channelnames.push_back(Channel.Name);
		Spec.channelformats.push_back(Channel.Type);
	}
	Spec.attribute("compression", "zip");
	Spec.x = Part.X;
	Spec.y = Part.Y;
	Spec.full_width = Part.FullWidth > 0 ? Part.FullWidth : Part.Width;
	Spec.full_height = Part.FullHeight > 0 ? Part.FullHeight : Part.Height;
	if (Part.bTiled)
	{
		Spec.tile_width = 16;
		Spec.tile_height = 16;
	}
	if (!Part.Name.empty())
	{
		Spec.attribute("oiio:subimagename", Part.Name);
	}
	if (!Part.Chromaticities.empty())
	{
		Spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), Part.Chromaticities.data());
	}
	for (const auto& [Name, Text] : Part.Attributes)
	{
		Spec.attribute(Name, Text);
	}
	return Spec;
}

/** Each channel in its own type; whole numbers as such. */
inline std::vector<char> MakePixels(const FPart& Part)
{
	std::vector<char> Bytes;
	for (int Y = 0; Y < Part.Height; ++Y)
	{
		for (int X = 0; X < Part.Width; ++X)
		{
			for (const FChannel& Channel : Part.Channels)
			{
				const double Value = Channel.Value(X, Y);
				const auto Add = [&Bytes](const auto& Number)
				{
					const char* const First = reinterpret_cast<const char*>(&Number);
					Bytes.insert(Bytes.end(), First, First + sizeof(Number));
				};
				if (Channel.Type == OIIO::TypeDesc::UINT32)
				{
					Add(static_cast<uint32_t>(Value));
				}
				else if (Channel.Type == OIIO::TypeDesc::HALF)
				{
					Add(half(static_cast<float>(Value)));
				}
				else
				{
					Add(static_cast<float>(Value));
				}
			}
		}
	}
	return Bytes;
}

inline void WriteParts(const std::string& Path, const std::vector<FPart>& Parts)
{
	std::filesystem::create_directories(std::filesystem::path(Path).parent_path());
	std::vector<OIIO::ImageSpec> Specs;
	for (const FPart& Part : Parts)
	{
		Specs.push_back(MakeSpec(Part));
	}
	const auto Output = OIIO::ImageOutput::create(Path);
	ASSERT_TRUE(Output && Output->open(Path, static_cast<int>(Specs.size()), Specs.data())) << Path;
	for (size_t Index = 0; Index < Parts.size(); ++Index)
	{
		if (Index > 0)
		{
			ASSERT_TRUE(Output->open(Path, Specs[Index], OIIO::ImageOutput::AppendSubimage)) << Output->geterror();
		}
		const std::vector<char> Pixels = MakePixels(Parts[Index]);
		// The type unknown: pixels are as the file has them.
		ASSERT_TRUE(Output->write_image(OIIO::TypeDesc::UNKNOWN, Pixels.data())) << Output->geterror();
	}
	ASSERT_TRUE(Output->close());
}

/** Files of one test, gone at its end. */
class FImportFolder : public testing::Test
{
protected:
	FImportFolder()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_import_" + std::to_string(getpid())))
	{
		std::filesystem::remove_all(Folder);
		std::filesystem::create_directories(Folder);
	}
	~FImportFolder() override { std::filesystem::remove_all(Folder); }

	std::string PathOf(const std::string& Name) const { return (Folder / Name).string(); }

	std::string Write(const std::string& Name, const FPart& Part) const
	{
		WriteParts(PathOf(Name), {Part});
		return PathOf(Name);
	}

	/** The plane of a channel in a file. */
	std::vector<float> Read(const std::string& Name, const std::string& Channel) const
	{
		FImageFile File(PathOf(Name));
		const int Index = File.FindChannel(Channel);
		EXPECT_GE(Index, 0) << Channel;
		return Index < 0 ? std::vector<float>() : File.Read({Index})[0];
	}

	using FImageFile = Drydock::FImageFile;
	const std::filesystem::path Folder;
};

/** "1095 2": numbers and the exit code. */
template<typename TFunction>
std::string ErrorOf(const TFunction& Function)
{
	try
	{
		Function();
		return "none";
	}
	catch (const Drydock::FError& Error)
	{
		std::string Text;
		for (const Drydock::FDiagnostic& Diagnostic : Error.GetDiagnostics())
		{
			Text += std::to_string(Diagnostic.Code) + " ";
		}
		return Text + std::to_string(Error.GetExitCode());
	}
}

} // namespace ImportTest
