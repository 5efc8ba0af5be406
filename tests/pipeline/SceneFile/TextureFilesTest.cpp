// Pictures that settings name, out of files.
#include <gtest/gtest.h>

#include "Picture/ImageFile.h"
#include "SceneFile/TextureFiles.h"
#include "SettingObjects.h"
#include "Text/ConfigErrors.h"

#include <filesystem>

using namespace Drydock;

namespace
{

/** A folder with a config in it, while it lives. */
class FFolder
{
public:
	FFolder()
		: Path(std::filesystem::temp_directory_path() / "TextureFilesTest")
	{
		std::filesystem::create_directories(Path);
		Config.File = (Path / "config.json").string();
	}
	~FFolder() { std::filesystem::remove_all(Path); }

	std::string GetPath(const std::string& Name) const { return (Path / Name).string(); }

	FConfig Config;

private:
	std::filesystem::path Path;
};

} // namespace

TEST(TextureFiles, ColoursOfAnExrRelativeToTheConfig)
{
	const FFolder Folder;
	WriteExr(Folder.GetPath("a.exr"), FImage{2, 1, 3, {0, 1, 2, 3, 4, 5}}, {"R", "G", "B"});
	const FTextureRHIRef Texture = MakeTextureLoader(Folder.Config)("a.exr");
	ASSERT_TRUE(Texture.IsValid());
	EXPECT_EQ(FIntPoint(2, 1), Texture->GetSizeXY());
	EXPECT_EQ(FLinearColor(3, 4, 5, 1), Texture->ReadTexel(1, 0));
}

TEST(TextureFiles, OneChannelIsGrey)
{
	const FFolder Folder;
	WriteExr(Folder.GetPath("a.exr"), FImage{1, 1, 1, {0.5}}, {"Y"});
	EXPECT_EQ(FLinearColor(0.5f, 0.5f, 0.5f, 1), MakeTextureLoader(Folder.Config)("a.exr")->ReadTexel(0, 0));
}

TEST(TextureFiles, PngIsDecoded)
{
	// Code 188 is 0.737255, and ((0.737255 + 0.055) / 1.055)^2.4 = 0.502886.
	const FFolder Folder;
	WritePng(Folder.GetPath("a.PNG"), FImage{1, 1, 3, {188 / 255.0, 0, 1}});
	const FLinearColor Color = MakeTextureLoader(Folder.Config)("a.PNG")->ReadTexel(0, 0);
	EXPECT_NEAR(0.502886f, Color.R, 1e-5f);
	EXPECT_EQ(0.0f, Color.G);
	EXPECT_EQ(1.0f, Color.B);
}

TEST(TextureFiles, AssetsHaveNoPixels)
{
	const FFolder Folder;
	EXPECT_FALSE(MakeTextureLoader(Folder.Config)("/Game/Lens/Kernel.Kernel").IsValid());
}

TEST(TextureFiles, AMissingFileIsAnError)
{
	const FFolder Folder;
	try
	{
		MakeTextureLoader(Folder.Config)("nowhere.exr");
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
		EXPECT_EQ(ErrorFileMissing, Error.GetDiagnostics()[0].Code);
	}
}

TEST(TextureFiles, APathIsLoadedOnceForALoader)
{
	const UTexture2D* const Asset = FindOrAddTexture("a.exr");
	int NumLoads = 0;
	const auto Load = [&](const std::string& Path)
	{
		++NumLoads;
		return MakePictureTexture(FIntPoint(1, 1), {FLinearColor(1, 2, 3, 1)}, Path);
	};
	{
		const FScopedTextureLoader Loader(Load);
		EXPECT_EQ(FindTexturePixels(Asset), FindTexturePixels(Asset));
		EXPECT_EQ(1, NumLoads);
		{
			const FScopedTextureLoader Inner([](const std::string&) { return nullptr; });
			EXPECT_FALSE(FindTexturePixels(Asset).IsValid());
		}
		EXPECT_TRUE(FindTexturePixels(Asset).IsValid());
	}
	EXPECT_FALSE(FindTexturePixels(Asset).IsValid());
}
