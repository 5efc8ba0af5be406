// Reads the main light's colour from a file's header.
#include "SceneFile/SceneLight.h"

#include "Config/ConfigReader.h"
#include "Text/Json.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

std::optional<FLinearColor> ReadSceneLightColor(const std::string& Json)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Json, "drydock:camera_json", Ignored, bSyntaxError);
	const FJsonValue* Value = Root.Find("main_light_color");
	FConfigVector Color;
	if (bSyntaxError || Value == nullptr || !ReadConfigVector(*Value, Color))
	{
		return std::nullopt;
	}
	const auto [Least, Greatest] = std::minmax_element(Color.begin(), Color.end());
	if (!(*Least >= 0.0) || !(*Greatest > 0.0) || !std::isfinite(*Greatest))
	{
		return std::nullopt;
	}
	return FLinearColor(static_cast<float>(Color[0] / *Greatest), static_cast<float>(Color[1] / *Greatest),
		static_cast<float>(Color[2] / *Greatest), 1.0f);
}

} // namespace Drydock
