// Checks any text in place of one that somebody keeps for drydock: what a scene's header says of its camera, the path
// of a walk, a shader's reflection in the cache, the log of a build, what a run printed, run.json. Every reader gets
// every text. The fuzzer uses this, and a test that runs its corpus.
#pragma once

#include "Blend/WalkPath.h"
#include "FuzzChecks.h"
#include "Patch/BuildLog.h"
#include "Matrix/MatrixRunReport.h"
#include "SceneFile/SceneLight.h"
#include "SceneFile/SceneSuggestions.h"
#include "ShaderCache.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The attribute drydock:camera_json: whatever it says, a run goes on. */
inline std::string CheckSceneText(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	const std::vector<FConfigVolume> Volumes = ReadSuggestedVolumes(Text, "scene.exr", Diagnostics);
	if (HasErrors(Diagnostics))
	{
		return "a scene's header is an error: " + FirstError(Diagnostics);
	}
	ReadSuggestedLocation(Text);
	const std::optional<FLinearColor> Light = ReadSceneLightColor(Text);
	if (Light && !(Light->GetMin() >= 0.0f && Light->GetMax() == 1.0f))
	{
		return "the main light has no colour";
	}
	return CheckVolumesAsText(Volumes);
}

inline std::string CheckPathText(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	const std::vector<FPathPoint> Points = ReadPath(Text, "path.json", Diagnostics);
	if (const std::string Problem = CheckMessages(Text, Diagnostics); !Problem.empty() || HasErrors(Diagnostics))
	{
		return Problem;
	}
	const bool bLabels =
		std::none_of(Points.begin(), Points.end(), [](const FPathPoint& Point) { return Point.Label.empty(); });
	return Points.size() >= 2 && bLabels ? "" : "a path without points or without labels";
}

inline std::string CheckReflectionText(const std::string& Text)
{
	const std::optional<FShaderReflection> Reflection = ReflectionFromJson(Text);
	if (!Reflection)
	{
		return "";
	}
	const std::string Written = ReflectionToJson(*Reflection);
	const std::optional<FShaderReflection> Again = ReflectionFromJson(Written);
	return Again && ReflectionToJson(*Again) == Written ? "" : "a reflection reads as something else:\n" + Written;
}

inline std::string CheckLogText(const std::string& Text)
{
	const std::vector<FBuildStep> Steps = ReadBuildSteps(Text);
	if (ReadBuildSteps(WriteBuildSteps(Steps)) != Steps)
	{
		return "a build's steps read as something else:\n" + WriteBuildSteps(Steps);
	}
	for (const ECompilerMessage Kind : {ECompilerMessage::Error, ECompilerMessage::Warning})
	{
		for (const FCompilerMessage& Message : ReadCompilerMessages(Text, Kind, "/Plugin"))
		{
			if (Message.Line < 0)
			{
				return "a message of the compiler stands on no line: " + Message.Text;
			}
		}
	}
	ReadMatrixRun(1, Text, "");
	ReadMatrixRun(0, "", Text);
	return "";
}

inline std::string CheckOtherText(const std::string& Text)
{
	for (const auto Check : {CheckSceneText, CheckPathText, CheckReflectionText, CheckLogText})
	{
		if (const std::string Problem = Check(Text); !Problem.empty())
		{
			return Problem;
		}
	}
	return "";
}

} // namespace Drydock
