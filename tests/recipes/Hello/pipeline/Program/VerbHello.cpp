// `drydock hello`: greets, as the recipe of docs/architecture.md makes a verb.
#include <CLI/CLI.hpp>

#include "Program/Verbs.h"

#include <cstdio>
#include <memory>
#include <string>

namespace Drydock
{

namespace
{

FVerbCall AddOptions(CLI::App& Verb)
{
	const auto Name = std::make_shared<std::string>("world");
	Verb.add_option("--name", *Name, "Whom to greet")->type_name("NAME");
	return [Name]
	{
		std::printf("hello %s\n", Name->c_str());
		return ExitDone;
	};
}

const FVerbRegistration GRegistration({
	.Name = "hello",
	.Place = 1000,
	.Group = EVerbGroup::Run,
	.Doc = "Greet somebody",
	.AddOptions = AddOptions,
});

} // namespace

} // namespace Drydock
