// The steps of reading a config, between Config.cpp and its helpers.
#pragma once

#include "Config/Config.h"
#include "DiagnosticList.h"
#include "Text/ConfigErrors.h"
#include "Text/Json.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The command line as the file of a message. */
constexpr const char* CommandLineName = "command line";

/** "; did you mean X?", or nothing. */
std::string Suggest(const std::string& Name, const std::vector<std::string>& Candidates);

/** A config, and a scene's header, have at most so many. Each holds all settings, some kilobytes. */
constexpr size_t MaxConfigVolumes = 10'000;

/** Collects messages about one file, as many as AddDiagnostic keeps. */
class FConfigMessages
{
public:
	FConfigMessages(const std::string& InFile, std::vector<FDiagnostic>& InDiagnostics)
		: File(InFile)
		, Diagnostics(InDiagnostics)
	{
	}

	/** Reports an error at a value. */
	void Error(int Code, const FJsonValue& At, const std::string& Message)
	{
		Add(ESeverity::Error, Code, At.Line, At.Column, At.Pointer, Message);
	}
	void Warn(int Code, const FJsonValue& At, const std::string& Message)
	{
		Add(ESeverity::Warning, Code, At.Line, At.Column, At.Pointer, Message);
	}
	/** Reports an error at the key of a member. */
	void ErrorAtKey(int Code, const FJsonValue& At, const std::string& Message)
	{
		Add(ESeverity::Error, Code, At.KeyLine, At.KeyColumn, At.Pointer, Message);
	}
	void WarnAtKey(int Code, const FJsonValue& At, const std::string& Message)
	{
		Add(ESeverity::Warning, Code, At.KeyLine, At.KeyColumn, At.Pointer, Message);
	}
	void Note(int Code, const FConfigPlace& At, const std::string& Message)
	{
		Add(ESeverity::Note, Code, At.Line, At.Column, At.Pointer, Message);
	}
	void Warn(int Code, const FConfigPlace& At, const std::string& Message)
	{
		Add(ESeverity::Warning, Code, At.Line, At.Column, At.Pointer, Message);
	}
	void Error(int Code, const FConfigPlace& At, const std::string& Message)
	{
		Add(ESeverity::Error, Code, At.Line, At.Column, At.Pointer, Message);
	}

	/** "; did you mean X?", or nothing, as where messages are no more than counted: whoever misspells thousands of
	 * names does not want each of them compared with all there are. GetCandidates: makes the names, where they are
	 * wanted. */
	template<typename TFunction>
	std::string SuggestFrom(const std::string& Name, const TFunction& GetCandidates) const
	{
		return Diagnostics.size() < MaxDiagnostics ? Drydock::Suggest(Name, GetCandidates()) : "";
	}
	/** The same for the name of a setting. For a setting of engine 4 the suggestion is the place where it is set today.
	 */
	std::string SuggestSetting(const std::string& Name) const;
	std::string Suggest(const std::string& Name, const std::vector<std::string>& Candidates) const
	{
		return Diagnostics.size() < MaxDiagnostics ? Drydock::Suggest(Name, Candidates) : "";
	}

private:
	void Add(
		ESeverity Severity, int Code, int Line, int Column, const std::string& Pointer, const std::string& Message);

	const std::string& File;
	std::vector<FDiagnostic>& Diagnostics;
};

/** Checks keys and types of a whole config against the list of keys, and reports features that are not built yet. */
void ValidateConfigShape(const FJsonValue& Root, FConfigMessages& Messages);

/** The Settings of a volume or camera. Not an object: nothing (that has been reported). */
FConfigSettings ReadConfigSettings(const FJsonValue& Value, FConfigMessages& Messages);

/** Keys of a setting's curve as the text that names it (CurveKeys.h); empty when something is wrong with them, which is
 * reported. Value: an object. */
std::optional<std::string> ReadConfigCurve(
	const FJsonValue& Value, const std::string& Setting, FConfigMessages& Messages);

/** Fields of engine text that drydock does not have. Values of another shape are skipped (they have been reported). */
std::vector<FUnknownSetting> ReadConfigUnknownSettings(const FJsonValue& Value);

/** The shape of a bounded volume; empty when it is incomplete, which is reported. */
std::optional<FConfigBounds> ReadConfigBounds(const FJsonValue& Value, FConfigMessages& Messages);

/** [x, y, z] or {X, Y, Z}; false when it is neither. */
bool ReadConfigVector(const FJsonValue& Value, FConfigVector& OutVector);

/** Pitch, yaw, roll: [pitch, yaw, roll], {Pitch, Yaw, Roll} with 0 for what is left out, or {X, Y, Z} in that order;
 * false when it is none of these. */
bool ReadConfigRotator(const FJsonValue& Value, FConfigVector& OutRotator);

FConfigPlace PlaceOf(const FJsonValue& Value);

/** Reports an unknown variable, or a value that the variable cannot take. */
void CheckVariable(const FConfigVariable& Variable, FConfigMessages& Messages);

} // namespace Drydock
