// Finds the template beside the library's other files and puts data into it.
#include "Report/ReportPage.h"

#include "InstallPaths.h"
#include "Report/PortablePaths.h"
#include "Report/ReportPicture.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

/** Stands in the template once, where the data goes. */
const std::string Placeholder = "\"drydock-report-data\"";

} // namespace

std::string FindPageFile(const std::string& Name)
{
	const std::string Installed = FindInstalled("share/drydock/report/" + Name);
	return Installed.empty() ? DRYDOCK_SOURCE_DIR "/report/" + Name : Installed;
}

std::string EscapeForScript(const std::string& Json)
{
	std::string Escaped;
	size_t From = 0;
	for (size_t At; (At = Json.find('<', From)) != std::string::npos; From = At + 1)
	{
		Escaped.append(Json, From, At - From).append("\\u003c");
	}
	return Escaped.append(Json, From);
}

std::string FormatReportTime(std::time_t Time)
{
	std::tm Utc{};
	gmtime_r(&Time, &Utc);
	char Text[32];
	std::strftime(Text, sizeof(Text), "%Y-%m-%dT%H:%M:%SZ", &Utc);
	return Text;
}

std::string MakeReportPage(const std::string& OwnData, size_t MaxPlainBytes)
{
	const std::string Data = MakePathsPortable(OwnData);
	const std::string Packed = Data.size() > MaxPlainBytes ? EncodeBase64(Deflate(Data)) : Data;
	const std::string File = FindPageFile("page.html");
	std::string Page = ReadTextFile(File, "drydock's own file cannot be opened: is drydock installed completely?");
	const size_t At = Page.find(Placeholder);
	if (At == std::string::npos)
	{
		throw FError({.Code = ErrorFileMissing,
						 .Message = "drydock's own page has no place for data: is it installed completely?",
						 .File = File},
			ExitFiles);
	}
	return Page.replace(
		At, Placeholder.size(), Packed.size() < Data.size() / 2 ? '"' + Packed + '"' : EscapeForScript(Data));
}

} // namespace Drydock
