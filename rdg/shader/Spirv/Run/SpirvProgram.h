// Lays a module out for the interpreter: the place of each constant, result and variable in one row of words, and the
// operands of each instruction. Functions do not recurse in HLSL, so each has its one place, too.
#pragma once

#include "SpirvGroups.h"
#include "SpirvPlace.h"

#include <memory>

namespace Drydock
{

constexpr uint32_t GNoSpirvWord = ~0u;

/** One instruction, with its words looked up. */
struct FSpirvStep
{
	const FSpirvInstruction* I = nullptr;
	uint32_t To = GNoSpirvWord;         // first word of the result
	uint32_t Size = 0;                  // words of the result
	uint32_t FirstArg = 0;              // into FSpirvProgram::Args: the first word of each operand that is a value
	uint32_t Place = ~0u;               // into FSpirvProgram::Places: access chains
	uint32_t Function = ~0u;            // into FSpirvProgram::Functions: calls; ~0: of a function that only discards
	ESpirvType Kind = ESpirvType::None; // of the first number that goes into it
	bool bNarrow = false;               // makes numbers of 16 bits
	bool bHook = false;                 // the observer wants to see it
	bool bSync = false;                 // threads of a group wait here for each other
	bool bOfOthers = false;             // its result may be the work of other threads
};

/** Words that a block takes over from the one that control came from. */
struct FSpirvEdge
{
	uint32_t From = 0; // label
	uint32_t To = 0;
	uint32_t Source = 0;
	uint32_t Size = 0;
};

struct FSpirvProgramBlock
{
	uint32_t FirstStep = 0;
	uint32_t NumSteps = 0; // the last one is the terminator
	std::vector<FSpirvEdge> Edges;
	bool bCounted = false; // the header of a loop that its text does not bound
};

struct FSpirvProgramFunction
{
	uint32_t FirstBlock = 0;
	std::vector<uint32_t> Parameters; // first words
	std::vector<uint32_t> Sizes;
};

/** A variable's memory. Handles (textures, samplers) have one word, which is an index into the module's variables. */
struct FSpirvMemory
{
	uint32_t First = 0;
	uint32_t Size = 0;
};

/** Pointers take three words: an offset (of a word, or bytes into a buffer), a structured buffer's element, and the
 * index of the buffer's variable. */
constexpr uint32_t GSpirvPointerWords = 3;

class DRYDOCK_API FSpirvProgram
{
public:
	/** Module must outlive it. Throws FSpirvError for what cannot be interpreted. */
	explicit FSpirvProgram(const FSpirvModule& Module);

	uint32_t WordsOf(uint32_t Type) const;
	/** First word of a value; GNoSpirvWord: not a value. */
	uint32_t WordOf(uint32_t Id) const { return Id < FirstWords.size() ? FirstWords[Id] : GNoSpirvWord; }
	/** A label's place in Blocks. Throws FSpirvError where it is none. */
	uint32_t BlockOf(uint32_t Label) const;
	const FSpirvPlace& PlaceOf(const FSpirvStep& Step) const { return Places[Step.Place]; }

	const FSpirvModule& Module;
	uint32_t NumWords = 0;
	std::vector<FSpirvStep> Steps;
	std::vector<uint32_t> Args;
	std::vector<uint32_t> ArgSizes; // words of each
	std::vector<FSpirvPlace> Places;
	std::vector<FSpirvProgramBlock> Blocks; // as in the module
	std::vector<FSpirvProgramFunction> Functions;
	std::vector<FSpirvMemory> Memory; // as the module's variables
	/** As the author named them, as the module's variables: a copy that a call passes has its parameter's name. Empty:
	 * the front end made it up. */
	std::vector<std::string> VariableNames;
	uint32_t EntryBlock = 0;
	FSpirvGroupUse Groups;
	FSpirvMemory Groupshared; // where the memory of groupshared variables lies: one behind the other

private:
	uint32_t Allocate(uint32_t Id, uint32_t Size);
	void AddBlock(const FSpirvBlock& Block);
	void AddStep(const FSpirvInstruction& I);
	void FindKinds(FSpirvStep& Step) const;
	void FindVariableNames();

	std::vector<uint32_t> FirstWords;   // by id
	std::vector<uint32_t> BlockOfLabel; // by id
};

} // namespace Drydock
