// `drydock hello`: greets, as the recipe of docs/architecture.md makes a verb.
#include "Program/ArgumentParser.h"
#include "Program/Verbs.h"

#include <cstdio>
#include <memory>
#include <string>

namespace Drydock
{

FVerbCall AddHelloOptions(FVerbOptions& Verb)
{
	const auto Name = std::make_shared<std::string>("world");
	Verb.Add("--name", *Name, "Whom to greet").SetType("NAME");
	return [Name]
	{
		std::printf("hello %s\n", Name->c_str());
		return ExitDone;
	};
}

} // namespace Drydock
