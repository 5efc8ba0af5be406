// One check per kind of instruction. SpirvChecker.cpp: control flow, memory and what is refused;
// SpirvCheckValues.cpp: vectors, matrices, textures; SpirvCheckKinds.cpp: floats and integers.
#pragma once

#include "SpirvCheck.h"

namespace Drydock
{

class FSpirvChecker
{
public:
	explicit FSpirvChecker(const FSpirvModule& InModule)
		: Module(InModule)
	{
	}

	void Check();

private:
	void CheckGroupSize();
	void CheckVariables();
	void CheckInput(const FSpirvVariable& Variable);
	void CheckBlock(const FSpirvBlock& Block);
	void CheckTerminator(const FSpirvInstruction& I);
	void CheckInstruction(const FSpirvInstruction& I);
	[[noreturn]] void FailCall(const FSpirvInstruction& I) const;
	void CheckGroupshared();
	void CheckOrder();
	bool CheckGroups(const FSpirvInstruction& I);
	void CheckWave(const FSpirvInstruction& I);
	void CheckQuad(const FSpirvInstruction& I);
	bool CheckMemory(const FSpirvInstruction& I);
	bool CheckComposite(const FSpirvInstruction& I);
	bool CheckMatrix(const FSpirvInstruction& I);
	bool CheckImage(const FSpirvInstruction& I);
	void CheckSample(const FSpirvInstruction& I);
	void CheckExtended(const FSpirvInstruction& I);
	void CheckKinds(const FSpirvInstruction& I) const;
	void CheckTexelKind(const FSpirvInstruction& I, const FSpirvType& Image) const;
	void CheckPhi(const FSpirvInstruction& I);

	void Expect(bool bCondition, const FSpirvInstruction& I) const
	{
		if (!bCondition)
		{
			Module.Fail("SPIR-V: " + GetSpirvOpName(I.Op) + " has operands that do not fit", &I);
		}
	}
	void ExpectCount(const FSpirvInstruction& I, size_t Least) const { Expect(I.Operands.size() >= Least, I); }
	/** Operand i is numeric; its scalars. */
	uint32_t Size(const FSpirvInstruction& I, size_t i) const
	{
		ExpectCount(I, i + 1);
		const uint32_t Result = Module.GetValueType(I.Operands[i]).NumScalars;
		Expect(Result != 0, I);
		return Result;
	}
	uint32_t ResultSize(const FSpirvInstruction& I) const { return Module.GetType(I.Type).NumScalars; }
	const FSpirvType& Image(const FSpirvInstruction& I, size_t i) const;

	const FSpirvModule& Module;
};

} // namespace Drydock
