// The words of encodings.
#include "Import/ImportEncoding.h"

namespace Drydock
{

const std::vector<std::string>& GetImportOriginWords()
{
	static const std::vector<std::string> Words = {"plain", "unreal", "blender", "drydock"};
	return Words;
}

const std::vector<std::string>& GetImportDepthWords()
{
	static const std::vector<std::string> Words = {"distance", "ray", "inverse", "device", "mist"};
	return Words;
}

const std::vector<std::string>& GetImportNormalSpaceWords()
{
	static const std::vector<std::string> Words = {"unreal", "world", "y-up", "camera"};
	return Words;
}

const std::vector<std::string>& GetImportVelocityWords()
{
	static const std::vector<std::string> Words = {"pixels", "pixels-up", "ndc", "unreal", "blender"};
	return Words;
}

const std::vector<std::string>& GetImportAlphaWords()
{
	static const std::vector<std::string> Words = {"premultiplied", "straight", "opaque"};
	return Words;
}

const std::vector<std::string>& GetImportUnitWords()
{
	static const std::vector<std::string> Words = {"m", "cm", "mm", "km"};
	return Words;
}

double GetMetres(const std::string& Unit)
{
	return Unit == "cm" ? 0.01 : Unit == "mm" ? 0.001 : Unit == "km" ? 1000.0 : 1.0;
}

} // namespace Drydock
