// Declares the events that an observer of the interpreter receives: steps, calls, and accesses that go wrong.
#pragma once

#include "SpirvProgram.h"

#include <string>

namespace Drydock
{

/** The thread that runs, to be read during a call of its observer. Words are FSpirvProgram's. */
class DRYDOCK_API FSpirvThreadView
{
public:
	virtual ~FSpirvThreadView();

	/** The low 32 bits of a word: an integer or a bool. */
	virtual uint32_t GetBits(uint32_t Word) const = 0;
	/** All bits of a word: an integer of 64 bits, a double. */
	virtual uint64_t GetWideBits(uint32_t Word) const = 0;
	/** A word that holds a float or a float16_t. */
	virtual double GetReal(uint32_t Word) const = 0;
	/** The number in a word, whatever it is. */
	double GetNumber(uint32_t Word, ESpirvType Kind) const;
	/** Calls that have not returned. */
	virtual size_t GetDepth() const = 0;
	/** Pixel or dispatch id. */
	virtual const int32_t* GetPosition() const = 0;
	/** Level of detail that derivatives gave the latest sample that asked for one. */
	virtual double GetLevel() const = 0;
};

enum class ESpirvFault : uint8_t
{
	Index,     // an array's element outside of it: the nearest was taken
	Texel,     // a load or store outside a texture: 0, or dropped
	Element,   // the same of a buffer
	Level,     // a sample at a level behind the last: the last was taken
	Undefined, // a value was used that nothing had written: 0
};

struct FSpirvFault
{
	ESpirvFault Kind = ESpirvFault::Index;
	std::string What;       // the array, texture, buffer or variable
	int64_t At[4] = {};     // index, or x, y, z, mip
	int64_t Bounds[3] = {}; // how many there are; of a level the mips
	bool bStore = false;
	bool bAtEnd = false; // an output when the thread was over: the step says nothing
};

/** "a read of SceneColor at (200, 3), which is 200 x 100" */
DRYDOCK_API std::string DescribeFault(const FSpirvFault& Fault);

class DRYDOCK_API ISpirvObserver
{
public:
	virtual ~ISpirvObserver();

	/** Called after a step that has a hook; for a step that ends a block, before control moves. */
	virtual void OnStep(const FSpirvThreadView&, const FSpirvStep&) {}
	/** A function of the module begins, its arguments are there; and has ended. */
	virtual void OnCall(const FSpirvThreadView&, const FSpirvStep&) {}
	virtual void OnReturn(const FSpirvThreadView&, const FSpirvStep& /*Call*/) {}
	/** Asked of steps with and without hooks. */
	virtual void OnFault(const FSpirvThreadView&, const FSpirvStep&, const FSpirvFault&) {}
};

} // namespace Drydock
