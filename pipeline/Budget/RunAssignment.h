// Reads what a study or a sweep sets: the name of a setting, a console variable or a place of the config, and its value.
#pragma once

#include "Budget/StudyConfig.h"
#include "Config/ConfigReader.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The text of a number, a string, true or false; nothing for another value, which is reported. */
std::optional<std::string> ReadValueText(const FJsonValue& Value, FConfigMessages& Messages);

/** Reports a value that is none of the names. What: "metric". */
void CheckIsOneOf(const FJsonValue& At, const std::string& Value, const std::vector<std::string>& Names,
	const char* What, FConfigMessages& Messages);

/** Reads names and values that a run can be set to. Console variables of plugins must be there. */
class FRunAssignmentReader
{
public:
	/** Special: names that are neither settings nor variables, "precision", "storage" and what the caller adds. File:
	 * named in messages, which are appended to Diagnostics. */
	FRunAssignmentReader(
		std::string InFile, std::vector<std::string> InSpecial, std::vector<FDiagnostic>& InDiagnostics);

	/** Reports a name that nothing has. */
	bool CheckName(const std::string& Name, const FJsonValue& At);

	/** Nothing when it is wrong, which is reported. NameAt: where the name stands. The values of the caller's special
	 * names are not looked at. */
	std::optional<FStudyAssignment> Read(const std::string& Name, const FJsonValue& NameAt, const FJsonValue& Value);

private:
	void CheckValue(const FStudyAssignment& Assignment, const FJsonValue& At);

	const std::string File;
	const std::vector<std::string> Special;
	std::vector<FDiagnostic>& Diagnostics;
	FConfigMessages Messages;
};

} // namespace Drydock
