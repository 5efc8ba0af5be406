// What the library exports stands in namespace Drydock or bears a name of the engine (EngineNames.txt), so that a
// plugin's own classes and functions never meet ours.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace
{

namespace Files = std::filesystem;

/** Namespace, class, function or variable that a symbol belongs to, outermost: "FRDGBuilder" of a member's symbol, of
 * the class's vtable and of its typeinfo. A symbol that is not mangled is itself its name. */
std::string GetOutermostName(const std::string& Symbol)
{
	static const std::regex Start("_Z(?:T[VIST]|Th?n?[0-9]+_|GV|[ZNKVLROP])*(S[tabsiod]|[0-9]+)");
	std::smatch Match;
	if (!std::regex_search(Symbol, Match, Start, std::regex_constants::match_continuous))
	{
		return Symbol;
	}
	return Match[1].str()[0] == 'S' ? "std"
									: Symbol.substr(static_cast<size_t>(Match.length()), std::stoul(Match[1].str()));
}

std::string Demangle(const std::string& Symbol)
{
	int Status = 0;
	char* const Text = abi::__cxa_demangle(Symbol.c_str(), nullptr, nullptr, &Status);
	const std::string Result = Status == 0 ? Text : Symbol;
	std::free(Text);
	return Result;
}

std::set<std::string> ReadEngineNames()
{
	std::set<std::string> Names;
	std::ifstream File(DRYDOCK_TEST_SOURCE_DIR "/tests/project/EngineNames.txt");
	for (std::string Line; std::getline(File, Line);)
	{
		const std::string Name = Line.substr(0, Line.find(" #"));
		if (!Name.empty() && Name[0] != '#')
		{
			Names.insert(Name);
		}
	}
	return Names;
}

/** Outermost names that a library exports, each with one of its symbols. */
std::map<std::string, std::string> ReadExports(const Files::path& Library)
{
	std::map<std::string, std::string> Exports;
	FILE* const Pipe = popen(("nm -D --defined-only '" + Library.string() + "'").c_str(), "r");
	char Line[1 << 16];
	while (Pipe != nullptr && std::fgets(Line, sizeof(Line), Pipe) != nullptr)
	{
		std::istringstream Fields(Line);
		std::string Address, Kind, Symbol;
		Fields >> Address >> Kind >> Symbol;
		if (!Symbol.starts_with("__odr_asan")) // the address sanitizer's own
		{
			Exports.emplace(GetOutermostName(Symbol), Symbol);
		}
	}
	EXPECT_TRUE(Pipe != nullptr && pclose(Pipe) == 0) << "nm cannot read " << Library;
	return Exports;
}

} // namespace

TEST(ExportedSymbols, AreOursInOurNamespaceOrTheEnginesByName)
{
	const std::set<std::string> Names = ReadEngineNames();
	int NumLibraries = 0;
	for (const auto& Entry : Files::directory_iterator(DRYDOCK_TEST_BINARY_DIR "/lib"))
	{
		const std::string Library = Entry.path().filename().string();
		// A module is loaded for itself (RTLD_LOCAL): its names meet nobody's.
		const bool bModule = Library == "libdrydock_openimageio.so" || Library == "libdrydock_http.so";
		if (!Library.starts_with("libdrydock") || Entry.path().extension() != ".so" || bModule)
		{
			continue;
		}
		++NumLibraries;
		for (const auto& [Name, Symbol] : ReadExports(Entry.path()))
		{
			EXPECT_TRUE(Names.count(Name) == 1 || Name.starts_with("DrydockHeaders_"))
				<< Library << " exports " << Name << " (" << Demangle(Symbol)
				<< "): put it into namespace Drydock, or, where Unreal has it, into tests/project/EngineNames.txt";
		}
	}
	EXPECT_GT(NumLibraries, 0);
}

TEST(ExportedSymbols, AnArticlesClassIsNotTheEngines)
{
	const std::set<std::string> Names = ReadEngineNames();
	EXPECT_EQ(1u, Names.count("FRDGBuilder"));
	EXPECT_EQ(0u, Names.count(GetOutermostName("_ZN15FDualKawaseBlur7SetPassEv")));
	EXPECT_EQ(0u, Names.count(GetOutermostName("_ZTV15FDualKawaseBlur")));
}

TEST(ExportedSymbols, OutermostNamesOfAllKinds)
{
	EXPECT_EQ("FRDGBuilder", GetOutermostName("_ZN11FRDGBuilder7ExecuteEv"));
	EXPECT_EQ("FRDGBuilder", GetOutermostName("_ZNK11FRDGBuilder7ExecuteEv"));
	EXPECT_EQ("FRDGBuilder", GetOutermostName("_ZTI11FRDGBuilder"));
	EXPECT_EQ("FRDGBuilder", GetOutermostName("_ZThn16_N11FRDGBuilderD1Ev"));
	EXPECT_EQ("FRDGBuilder", GetOutermostName("_ZGVZN11FRDGBuilder7ExecuteEvE4Once"));
	EXPECT_EQ("Drydock", GetOutermostName("_ZTVN7Drydock6FErrorE"));
	EXPECT_EQ("AddDrawTexturePass", GetOutermostName("_Z18AddDrawTexturePassR11FRDGBuilder"));
	EXPECT_EQ("std", GetOutermostName("_ZNSt6vectorIiSaIiEE9push_backEOi"));
	EXPECT_EQ("GEngine", GetOutermostName("GEngine"));
}
