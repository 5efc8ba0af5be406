// Declares the options of a verb and the parser that reads them. Only ArgumentParser.cpp includes the parser library,
// because its header takes seconds to compile.
#pragma once

#include "Program/Verbs.h"
#include "Templates/UnrealTemplate.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace Drydock
{

struct FVerbModel;

/** One option of a verb, or one argument. Copies mean the same option, which lives as long as the parser. Each function
 * returns the option, so that calls follow each other. */
class FVerbOption
{
public:
	explicit FVerbOption(CLI::Option* Option);

	/** Name: its value as --help shows it, "FILE". Without a call, --help shows what the variable holds, "INT". */
	FVerbOption SetType(const std::string& Name) const;

	/** The heading that --help shows it under; "Options" without a call. */
	FVerbOption SetGroup(const std::string& Heading) const;

	/** A usage error where it is not given. */
	FVerbOption Require() const;

	/** A usage error where both are given. */
	FVerbOption Exclude(const FVerbOption& Other) const;

	/** A usage error where it is given without the other one. */
	FVerbOption Need(const FVerbOption& Other) const;

	/** The option may be given without a value, and has this one then. */
	FVerbOption SetValueWhereNoneFollows(const std::string& Value) const;

	/** Its variable is a list, whose values stand in one word with commas between. */
	FVerbOption SplitAtCommas() const;

	/** Takes exactly NumValues values. Commas or spaces stand between them. */
	FVerbOption SplitAtCommas(int NumValues) const;

	/** Whole numbers from Least to Most are taken, all else is a usage error. */
	FVerbOption RequireRange(int Least, int Most) const;

	/** Numbers from Least to Most are taken, all else is a usage error. */
	FVerbOption RequireRange(double Least, double Most) const;

	/** Numbers from 0 on are taken, all else is a usage error. */
	FVerbOption RequireNonNegative() const;

	/** One of these words is taken, all else is a usage error, which offers the nearest word. They become the option's
	 * type, "a|b", which --help shows and completion offers. */
	FVerbOption RequireOneOf(const std::vector<std::string>& Words) const;

	/** Takes some of these words with commas between; the type is "a|b,...". */
	FVerbOption RequireSomeOf(const std::vector<std::string>& Words) const;

private:
	CLI::Option* Option;
};

/** The options of one verb. Name: "--out", or "CONFIG" for an argument that is recognised by its place. Doc: its line
 * in --help. A variable keeps its value where its option is not given; it lives until the verb is called, as those of
 * the call that FVerb::AddOptions returns do. A value that is not of the variable's type is a usage error. */
class FVerbOptions
{
public:
	explicit FVerbOptions(CLI::App* Verb);

	/** T: std::string, int or double; std::optional or, up to the next option, std::vector of such. */
	template<typename T>
	FVerbOption Add(const std::string& Name, T& Value, const std::string& Doc);

	/** Calls Take with the value once all arguments are read. Take may throw FError. */
	FVerbOption Add(
		const std::string& Name, const std::function<void(const std::string& Value)>& Take, const std::string& Doc);
	FVerbOption Add(const std::string& Name, const std::function<void(const std::vector<std::string>& Values)>& Take,
		const std::string& Doc);

	/** An option that repeats and takes one value each time, so that a config may follow it. Type: as of SetType. */
	FVerbOption AddRepeated(
		const std::string& Name, const std::string& Type, std::vector<std::string>& Values, const std::string& Doc);

	/** Adds an option whose values Take is called with as each is read, in the order of the command line. */
	FVerbOption AddInOrder(const std::string& Name, const std::string& Type,
		const std::function<void(const std::string& Value)>& Take, const std::string& Doc);

	/** True where it is given. It has no value. */
	FVerbOption AddFlag(const std::string& Name, bool& bGiven, const std::string& Doc);

	/** Calls Act where it is given, once all arguments are read. */
	FVerbOption AddFlag(const std::string& Name, const std::function<void()>& Act, const std::string& Doc);

	/** An option that was added before. Throws std::exception where there is none. */
	FVerbOption Find(const std::string& Name) const;

	/** A usage error where none of the verbs under this one is named. */
	void RequireVerb();

private:
	CLI::App* Verb;
};

/** The texts of the program as a whole. */
struct FProgramText
{
	std::string Name;
	std::string Doc;     // the first line of --help
	std::string Version; // as --version prints it
	std::string Footer;  // the last paragraph of --help
};

enum class EParsed
{
	Called,  // the verb was called
	Asked,   // for --help or --version, which no verb is called for
	Mistaken // the arguments do not fit
};

/** The result of parsing the arguments. */
struct FParsedArguments
{
	EParsed Parsed = EParsed::Called;
	int ExitCode = ExitDone; // of the verb; ExitDone where help was asked for, ExitUsage of a mistake
	std::string Text;        // help, version, or the mistake in one sentence; empty where the verb was called
};

/** The parser of the program's arguments. */
class FArgumentParser : private FNoncopyable
{
public:
	/** Verbs: one that others stand under is before them. */
	FArgumentParser(const FProgramText& Text, const std::vector<FVerb>& Verbs);
	~FArgumentParser();

	/** Finds the verb, sets its variables and calls it. Arguments: those behind the program's name. `--passes` is read
	 * as
	 * `--pass`. Throws what the
	 * verb throws, and what functions of its options throw. It may be called once. */
	FParsedArguments Parse(const std::vector<std::string>& Arguments);

	/** Whether the verb that Parse found has this option, "--json", and the arguments gave it; also after Parse threw.
	 */
	bool IsGiven(const std::string& Option) const;

	/** The program itself, then its verbs, those under a verb behind it. */
	std::vector<FVerbModel> Read() const;

private:
	std::unique_ptr<CLI::App> Program;
	int ExitCode = ExitDone; // of the verb that was called
};

} // namespace Drydock
