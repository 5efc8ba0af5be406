// Collects messages about a config, with their places.
#include "Config/ConfigReader.h"

namespace Drydock
{

FConfigPlace PlaceOf(const FJsonValue& Value)
{
	return {Value.Line, Value.Column, Value.Pointer};
}

std::string Suggest(const std::string& Name, const std::vector<std::string>& Candidates)
{
	const std::string Nearest = FindNearestName(Name, Candidates);
	return Nearest.empty() ? "" : "; did you mean " + Nearest + "?";
}

void FConfigMessages::Add(
	ESeverity Severity, int Code, int Line, int Column, const std::string& Pointer, const std::string& Message)
{
	AddDiagnostic(Diagnostics, {Severity, Code, Message, File, Line, Column, Pointer});
}

} // namespace Drydock
