// Writes the scene file of small frames.
#include "SceneFolder.h"

#include "Picture/ImageFile.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

namespace Stability
{

namespace
{

std::filesystem::path MakeFolder()
{
	std::string Folder = (std::filesystem::temp_directory_path() / "drydock_scene.XXXXXX").string();
	if (mkdtemp(Folder.data()) == nullptr)
	{
		throw std::runtime_error("the folder of a scene cannot be made: " + Folder);
	}
	return Folder;
}

/** The camera of another small scene, for a picture of this size. */
std::string MakeCamera(int Width, int Height)
{
	std::ifstream File(DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/two_boxes.json");
	nlohmann::ordered_json Camera = nlohmann::ordered_json::parse(File);
	Camera["scene"] = "scene";
	Camera["width"] = Width;
	Camera["height"] = Height;
	Camera["focal_length_px"] = 30.0;
	return Camera.dump();
}

} // namespace

FSceneFolder::FSceneFolder(const Drydock::FImage& Picture, const std::vector<std::string>& Channels)
	: Path(MakeFolder())
{
	Drydock::WriteExr((Path / "scene.exr").string(), Picture, Channels,
		{{"drydock:camera_json", MakeCamera(Picture.Width, Picture.Height)}});
}

FSceneFolder::~FSceneFolder()
{
	if (std::getenv("DRYDOCK_RANDOM_KEEP") != nullptr)
	{
		std::printf("%s is kept\n", Path.c_str());
		return;
	}
	std::error_code Ignored;
	std::filesystem::remove_all(Path, Ignored);
}

} // namespace Stability
