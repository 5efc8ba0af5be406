// What must hold for any bytes: used by the fuzzers, and by a test that runs their corpus. Each check returns what does
// not hold, or nothing.
#pragma once

#include "Budget/StudyConfig.h"
#include "Config/ReadConfig.h"
#include "Text/JsonWriter.h"
#include "Config/SettingsJson.h"

#include <algorithm>
#include <string>
#include <vector>

namespace Drydock
{

/** Volumes as text, without their shapes: six decimals round these a little more at each writing. */
inline std::string Summarize(const std::vector<FVolumeText>& Volumes)
{
	std::string Text;
	std::vector<FDiagnostic> Unused;
	for (const FVolumeText& Volume : Volumes)
	{
		FVolumeText Copy = Volume;
		Copy.Box.reset();
		Text += WriteVolumesText({Copy}, ESettingsTextForm::Delta, Unused);
	}
	return Text;
}

/** Messages have a number, a sentence and a place inside the text. */
inline std::string CheckMessages(const std::string& Text, const std::vector<FDiagnostic>& Diagnostics)
{
	const auto NumLines = 1 + std::count(Text.begin(), Text.end(), '\n');
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		const bool bPlace = Diagnostic.Line >= 0 && Diagnostic.Line <= NumLines && Diagnostic.Column >= 0;
		if (!bPlace || Diagnostic.Code < 1001 || Diagnostic.Message.empty())
		{
			return "a message without number, sentence or place: " + Diagnostic.ToString();
		}
	}
	return "";
}

inline std::string FirstError(const std::vector<FDiagnostic>& Diagnostics)
{
	const auto Found = std::find_if(Diagnostics.begin(), Diagnostics.end(),
		[](const FDiagnostic& Diagnostic) { return Diagnostic.Severity == ESeverity::Error; });
	return Found == Diagnostics.end() ? "" : Found->ToString();
}

/** All that six decimals and labels change is changed by writing once. */
inline std::vector<FVolumeText> Settle(const std::vector<FVolumeText>& Volumes)
{
	std::vector<FDiagnostic> Unused;
	return ReadVolumesText(WriteVolumesText(Volumes, ESettingsTextForm::Delta, Unused), "settled.txt", Unused);
}

/** What was read without errors is written so that it reads back, through engine text and through a config. */
inline std::string CheckSettingsText(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FVolumeText> Volumes = ReadVolumesText(Text, "clip.txt", Diagnostics);
	if (const std::string Problem = CheckMessages(Text, Diagnostics); !Problem.empty() || HasErrors(Diagnostics))
	{
		return Problem;
	}
	Volumes = Settle(Volumes);
	Diagnostics.clear();
	const std::string Written = WriteVolumesText(Volumes, ESettingsTextForm::Delta, Diagnostics);
	const std::vector<FVolumeText> Again = ReadVolumesText(Written, "again.txt", Diagnostics);
	if (const std::string Error = FirstError(Diagnostics); !Error.empty())
	{
		return "what is written does not read: " + Error + "\n" + Written;
	}
	if (Summarize(Again) != Summarize(Volumes))
	{
		return "what is written reads as something else:\n" + Written;
	}
	FJsonWriter Writer;
	WriteVolumes(Writer, Volumes);
	Diagnostics.clear();
	const FConfig Config = ReadConfig("{\"volumes\": " + Writer.GetText() + "}", "a.json", Diagnostics);
	std::vector<FVolumeText> Configured;
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Configured.push_back(MakeVolumeText(Volume, "a.json", Diagnostics));
	}
	return Summarize(Configured) == Summarize(Volumes) ? "" : "the config differs:\n" + Writer.GetText();
}

/** Volumes are engine text that reads back. */
inline std::string CheckVolumesAsText(const std::vector<FConfigVolume>& ConfigVolumes)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FVolumeText> Volumes;
	for (const FConfigVolume& Volume : ConfigVolumes)
	{
		Volumes.push_back(MakeVolumeText(Volume, "a.json", Diagnostics));
	}
	if (HasErrors(Diagnostics) || Volumes.empty())
	{
		return "";
	}
	Diagnostics.clear();
	const std::string Written = WriteVolumesText(Volumes, ESettingsTextForm::Delta, Diagnostics);
	const std::vector<FVolumeText> Again = ReadVolumesText(Written, "clip.txt", Diagnostics);
	const std::string Error = FirstError(Diagnostics);
	return !Error.empty()                   ? "the exported text does not read: " + Error + "\n" + Written
		   : Again.size() != Volumes.size() ? "the exported text has other volumes:\n" + Written
											: "";
}

/** Any text is a config or has messages, its study too; its volumes are engine text. */
inline std::string CheckConfigJson(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(Text, "a.json", Diagnostics);
	ReadStudy(Config, Diagnostics);
	const std::string Problem = CheckMessages(Text, Diagnostics);
	return !Problem.empty() || HasErrors(Diagnostics) ? Problem : CheckVolumesAsText(Config.Volumes);
}

} // namespace Drydock
