// Variables by the names that a shader's author gave them.
#pragma once

#include "SpirvObserver.h"

#include <map>
#include <optional>
#include <string>

namespace Drydock
{

struct FNamedVariable
{
	std::string Name;
	uint32_t Type = 0; // numeric
};

/** Whether the author wrote a block's function, by block of the program. The front end wraps the entry point in a
 * function of its own, which has lines of the author's. */
std::vector<bool> FindAuthorsBlocks(const FSpirvModule& Module);

class FAuthorsNames
{
public:
	/** Program outlives it. */
	explicit FAuthorsNames(const FSpirvProgram& InProgram);

	/** The variable or parameter, or the part of one, that a pointer points to. Nothing where the front end made it up.
	 */
	std::optional<FNamedVariable> Find(uint32_t Pointer) const;

	/** First word of the whole variable that a pointer points into while a thread runs; GNoSpirvWord: it is none. */
	uint32_t FindWords(const FSpirvThreadView& Thread, uint32_t PointerWord) const;

private:
	const FSpirvProgram& Program;
	std::map<uint32_t, uint32_t> Bases; // of access chains
};

} // namespace Drydock
