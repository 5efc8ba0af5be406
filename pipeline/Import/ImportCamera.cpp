// Reads cameras. Source of the rotation: engine's FRotationMatrix (pitch, yaw, roll to axes).
#include "Import/ImportCamera.h"

#include "SceneFile/SceneCamera.h"
#include "Text/JsonWriter.h"

#include <charconv>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr double DegreesToRadians = 3.14159265358979323846 / 180.0;

std::optional<double> ParseNumber(const std::string& Text)
{
	double Number = 0.0;
	const std::from_chars_result Result = std::from_chars(Text.data(), Text.data() + Text.size(), Number);
	return Result.ec == std::errc() && std::isfinite(Number) ? std::optional(Number) : std::nullopt;
}

/** The number of the first attribute of Unreal that ends with End. */
std::optional<double> FindNumber(const std::map<std::string, std::string>& Attributes, const std::string& End)
{
	for (const auto& [Name, Text] : Attributes)
	{
		if (Name.starts_with("unreal/") && Name.ends_with(End))
		{
			return ParseNumber(Text);
		}
	}
	return std::nullopt;
}

std::optional<std::array<double, 3>> FindNumbers(const std::map<std::string, std::string>& Attributes,
	const std::string& Of, const std::array<const char*, 3>& Names)
{
	std::array<double, 3> Numbers = {};
	for (size_t Index = 0; Index < 3; ++Index)
	{
		const std::optional<double> Number = FindNumber(Attributes, "/" + Of + "/" + Names[Index]);
		if (!Number)
		{
			return std::nullopt;
		}
		Numbers[Index] = *Number;
	}
	return Numbers;
}

std::optional<double> FindFov(const std::map<std::string, std::string>& Attributes)
{
	if (const std::optional<double> Fov = FindNumber(Attributes, "/fov"); Fov && *Fov > 0.0 && *Fov < 180.0)
	{
		return Fov;
	}
	const std::optional<double> Focal = FindNumber(Attributes, "/focalLength");
	const std::optional<double> Sensor = FindNumber(Attributes, "/sensorWidth");
	const bool bLens = Focal && Sensor && *Focal > 0.0 && *Sensor > 0.0;
	return bLens ? std::optional(2.0 * std::atan(0.5 * *Sensor / *Focal) / DegreesToRadians) : std::nullopt;
}

/** "24", "24.0" or "24000/1001". */
std::optional<double> FindDeltaTime(const std::map<std::string, std::string>& Attributes)
{
	const auto Found = Attributes.find("unreal/frameRate");
	if (Found == Attributes.end())
	{
		return std::nullopt;
	}
	const size_t Slash = Found->second.find('/');
	const std::optional<double> Rate = ParseNumber(Found->second.substr(0, Slash));
	const std::optional<double> By =
		Slash == std::string::npos ? std::optional(1.0) : ParseNumber(Found->second.substr(Slash + 1));
	return Rate && By && *Rate > 0.0 && *By > 0.0 ? std::optional(*By / *Rate) : std::nullopt;
}

} // namespace

FImportCamera ReadImportCamera(const std::map<std::string, std::string>& Attributes, const FImportAsked& Asked)
{
	FImportCamera Camera;
	if (const auto Json = Attributes.find("drydock:camera_json"); Json != Attributes.end())
	{
		Camera.Json = Json->second;
		if (const std::optional<FSceneCamera> Scene = ReadSceneCamera(Camera.Json))
		{
			Camera.Location = {Scene->Location.X, Scene->Location.Y, Scene->Location.Z};
			Camera.Rotation = {Scene->Pitch, Scene->Yaw, Scene->Roll};
			Camera.Fov = Scene->HorizontalFov;
		}
		return Camera;
	}
	Camera.Location = FindNumbers(Attributes, "curPos", {"x", "y", "z"});
	Camera.Rotation = FindNumbers(Attributes, "curRot", {"pitch", "yaw", "roll"});
	Camera.Fov = FindFov(Attributes);
	Camera.DeltaTime = FindDeltaTime(Attributes);
	Camera.Location = Asked.Location ? Asked.Location : Camera.Location;
	Camera.Rotation = Asked.Rotation ? Asked.Rotation : Camera.Rotation;
	Camera.Fov = Asked.Fov ? Asked.Fov : Camera.Fov;
	return Camera;
}

std::string MakeCameraJson(const FImportCamera& Camera, int Width, int Height, std::optional<int> Frame)
{
	if (!Camera.Json.empty() || (!Camera.Location && !Camera.Rotation && !Camera.Fov && !Camera.DeltaTime))
	{
		return Camera.Json;
	}
	const std::array<double, 3> Location = Camera.Location.value_or(std::array<double, 3>());
	const std::array<double, 3> Rotation = Camera.Rotation.value_or(std::array<double, 3>());
	FJsonWriter Writer('{');
	Writer.MemberIfAny("frame", Frame);
	Writer.MemberIfAny("delta_time_s", Camera.DeltaTime);
	Writer.Member("position_uecm", Location);
	Writer.Key("rotator_ue_deg").Object({{"pitch", Rotation[0]}, {"yaw", Rotation[1]}, {"roll", Rotation[2]}});
	Writer.MemberIfAny("hfov_deg", Camera.Fov);
	Writer.Members({{"width", Width}, {"height", Height}});
	return Writer.GetText();
}

std::optional<double> GetFocalLength(const FImportCamera& Camera, int Width)
{
	return Camera.Fov ? std::optional(0.5 * Width / std::tan(0.5 * *Camera.Fov * DegreesToRadians)) : std::nullopt;
}

std::array<double, 3> CameraToWorld(const std::array<double, 3>& Vector, const std::array<double, 3>& Rotation)
{
	const auto [SP, CP] = std::pair(std::sin(Rotation[0] * DegreesToRadians), std::cos(Rotation[0] * DegreesToRadians));
	const auto [SY, CY] = std::pair(std::sin(Rotation[1] * DegreesToRadians), std::cos(Rotation[1] * DegreesToRadians));
	const auto [SR, CR] = std::pair(std::sin(Rotation[2] * DegreesToRadians), std::cos(Rotation[2] * DegreesToRadians));
	const std::array<double, 3> Forward = {CP * CY, CP * SY, SP};
	const std::array<double, 3> Right = {SR * SP * CY - CR * SY, SR * SP * SY + CR * CY, -SR * CP};
	const std::array<double, 3> Up = {-(CR * SP * CY + SR * SY), CY * SR - CR * SP * SY, CR * CP};
	std::array<double, 3> World = {};
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		World[Axis] = Right[Axis] * Vector[0] + Up[Axis] * Vector[1] - Forward[Axis] * Vector[2];
	}
	World[1] = -World[1]; // the engine's axes are left-handed
	return World;
}

} // namespace Drydock
