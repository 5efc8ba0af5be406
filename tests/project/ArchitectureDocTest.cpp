// docs/architecture.md and the tree agree: every room has a row that says what it is for, and no row names another.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace
{

namespace Files = std::filesystem;

const Files::path GRoot = DRYDOCK_TEST_SOURCE_DIR;

std::string ReadPage()
{
	std::ostringstream Text;
	Text << std::ifstream(GRoot / "docs/architecture.md").rdbuf();
	return Text.str();
}

/** "rdg/core/Core", ...: folders of a storey that hold files. */
std::set<std::string> FindRooms()
{
	std::set<std::string> Rooms;
	for (const char* const Storey :
		{"rdg", "rdg/core", "rdg/graph", "rdg/shader", "rdg/shader/Spirv", "settings", "passes", "pipeline"})
	{
		for (const auto& Entry : Files::directory_iterator(GRoot / Storey))
		{
			if (Entry.is_directory() && !Files::is_empty(Entry.path()))
			{
				Rooms.insert(std::string(Storey) + "/" + Entry.path().filename().string());
			}
		}
	}
	return Rooms;
}

/** What the first cells of the map name. */
std::set<std::string> FindRows()
{
	std::set<std::string> Rows;
	std::istringstream Lines(ReadPage());
	const std::regex Name("`((?:rdg|settings|passes|pipeline)/[A-Za-z/]+)`");
	for (std::string Line; std::getline(Lines, Line);)
	{
		const std::string First = Line.starts_with("| `") ? Line.substr(0, Line.find('|', 1)) : "";
		for (std::sregex_iterator It(First.begin(), First.end(), Name), End; It != End; ++It)
		{
			Rows.insert((*It)[1]);
		}
	}
	return Rows;
}

} // namespace

TEST(ArchitectureDoc, EveryRoomHasARow)
{
	const std::set<std::string> Rows = FindRows();
	EXPECT_GT(Rows.size(), 30u);
	for (const std::string& Room : FindRooms())
	{
		EXPECT_TRUE(Rows.count(Room)) << Room << " is missing in the map of docs/architecture.md";
	}
}

TEST(ArchitectureDoc, EveryRowIsARoom)
{
	const std::set<std::string> Rooms = FindRooms();
	for (const std::string& Row : FindRows())
	{
		EXPECT_TRUE(Rooms.count(Row)) << Row << " is in the map of docs/architecture.md, and no folder";
	}
}

TEST(Pages, NameTestsThatExist)
{
	const std::regex Named("`(tests/[A-Za-z0-9_/]+\\.(cpp|sh))`");
	for (const auto& Entry : Files::recursive_directory_iterator(GRoot / "docs"))
	{
		if (Entry.path().extension() != ".md")
		{
			continue;
		}
		std::ostringstream Page;
		Page << std::ifstream(Entry.path()).rdbuf();
		const std::string Text = Page.str();
		for (std::sregex_iterator Match(Text.begin(), Text.end(), Named), End; Match != End; ++Match)
		{
			const std::string Path = (*Match)[1];
			const bool bPlaceholder = Path.find("/ROOM/") != std::string::npos;
			EXPECT_TRUE(bPlaceholder || Files::exists(GRoot / Path)) << Entry.path().filename() << ": " << Path;
		}
	}
}
