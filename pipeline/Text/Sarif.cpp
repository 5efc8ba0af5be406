// Writes SARIF.
#include "Text/Sarif.h"

#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/Version.h"

#include <cctype>
#include <filesystem>
#include <set>

namespace Drydock
{

namespace
{

std::string GetRule(const FFinding& Finding)
{
	return Finding.Rule.empty() ? "DD" + std::to_string(Finding.Diagnostic.Code) : Finding.Rule;
}

/** A reference relative to the working folder, or a file's URI. */
std::string MakeUri(const std::string& File)
{
	std::error_code Error;
	const std::filesystem::path Relative = std::filesystem::proximate(File, Error);
	const bool bBelow = !Error && !Relative.empty() && *Relative.begin() != "..";
	const std::string Path =
		bBelow ? Relative.generic_string() : std::filesystem::absolute(File, Error).generic_string();
	std::string Uri = bBelow ? "" : "file://";
	for (const char Character : Path)
	{
		const bool bPlain = std::isalnum(static_cast<unsigned char>(Character)) ||
							std::string("/-._~").find(Character) != std::string::npos;
		Uri += bPlain ? std::string(1, Character) : fmt::format("%{:02X}", static_cast<unsigned char>(Character));
	}
	return Uri;
}

void WriteResult(FJsonWriter& Writer, const FFinding& Finding, const std::string& File)
{
	const FDiagnostic& Said = Finding.Diagnostic;
	constexpr const char* Levels[] = {"note", "warning", "error"};
	Writer.Members({{"ruleId", GetRule(Finding)}, {"level", Levels[size_t(Said.Severity)]}});
	Writer.Key("message").Object({{"text", Said.Message}});
	Writer.Key("locations").BeginArray(true);
	Writer.BeginObject(true);
	Writer.Key("physicalLocation").BeginObject(true);
	Writer.Key("artifactLocation").Object({{"uri", MakeUri(Said.File.empty() ? File : Said.File)}});
	if (Said.Line > 0)
	{
		Writer.Key("region").BeginObject(true);
		Writer.Member("startLine", Said.Line);
		Writer.MemberIfAny("startColumn", Said.Column);
		Writer.EndObject();
	}
	Writer.EndObject();
	if (!Said.Where.empty())
	{
		Writer.Objects("logicalLocations", std::vector<std::string>{Said.Where},
			[&](const std::string& Where) { Writer.Member("fullyQualifiedName", Where); });
	}
	Writer.EndObject();
	Writer.EndArray();
}

} // namespace

std::string MakeSarif(const std::string& Verb, const std::string& File, const std::vector<FFinding>& Findings)
{
	std::set<std::string> Rules;
	for (const FFinding& Finding : Findings)
	{
		Rules.insert(GetRule(Finding));
	}
	FJsonWriter Writer('{');
	Writer.Members({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"}, {"version", "2.1.0"}});
	Writer.Key("runs").BeginArray();
	Writer.BeginObject();
	Writer.Key("tool").BeginObject();
	Writer.Key("driver").BeginObject();
	Writer.Members({{"name", "drydock " + Verb}, {"version", GetVersion()}});
	Writer.Objects("rules", Rules, [&](const std::string& Rule) { Writer.Member("id", Rule); });
	Writer.EndObject();
	Writer.EndObject();
	Writer.Objects("results", Findings, [&](const FFinding& Finding) { WriteResult(Writer, Finding, File); });
	return Writer.GetText();
}

} // namespace Drydock
