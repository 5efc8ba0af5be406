// Finds absolute paths in a text, and shortens them.
#include "Report/PortablePaths.h"

#include "InstallPaths.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <vector>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

std::set<std::string> ListRootFolders()
{
	std::set<std::string> Names;
	std::error_code Error;
	for (Files::directory_iterator Entry("/", Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		Names.insert(Entry->path().filename().string());
	}
	return Names;
}

/** Folders whose files keep their path below them; the longest first. */
std::vector<std::string> ListKnownFolders()
{
	std::error_code Ignored;
	const Files::path Installed = FindInstalled("share/drydock");
	std::vector<std::string> Known = {Files::current_path(Ignored).string(), DRYDOCK_SOURCE_DIR,
		Installed.empty() ? "" : Installed.lexically_normal().parent_path().parent_path().string()};
	std::erase_if(Known, [](const std::string& Folder) { return Folder.size() <= 1; });
	std::ranges::sort(Known, std::ranges::greater(), &std::string::size);
	return Known;
}

/** Characters before a slash that is not a path's first. The plus sign is one of base64. */
bool IsInsideWord(char Character)
{
	return std::isalnum(static_cast<unsigned char>(Character)) != 0 ||
		   std::string("_.-/+~").find(Character) != std::string::npos;
}

} // namespace

std::string MakePathsPortable(const std::string& Text)
{
	const std::set<std::string> Roots = ListRootFolders();
	const std::vector<std::string> Known = ListKnownFolders();
	std::string Portable;
	size_t From = 0;
	for (size_t At = Text.find('/'); At != std::string::npos; At = Text.find('/', At + 1))
	{
		if (At > 0 && IsInsideWord(Text[At - 1]))
		{
			continue;
		}
		const size_t Second = Text.find_first_of("/\"\\ ", At + 1);
		if (Second == std::string::npos || Text[Second] != '/' ||
			Roots.count(Text.substr(At + 1, Second - At - 1)) == 0)
		{
			continue;
		}
		const auto Under = std::ranges::find_if(Known, [&](const std::string& Folder)
			{ return Text.compare(At, Folder.size(), Folder) == 0 && Text[At + Folder.size()] == '/'; });
		Portable.append(Text, From, At - From);
		if (Under != Known.end())
		{
			From = At + Under->size() + 1;
		}
		else
		{
			const size_t End = std::min(Text.find_first_of("\"\\ \t\n'`,;:()<>|", Second), Text.size());
			From = Text.rfind('/', End - 1);
			Portable += "...";
		}
		At = From;
	}
	return Portable.append(Text, From);
}

} // namespace Drydock
