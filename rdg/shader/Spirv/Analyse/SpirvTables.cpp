// Finds the variables that are tables in truth: `static const float W[3] = {...}` reaches us as a local array that is
// stored once.
#include "SpirvUniformity.h"

namespace Drydock
{

using namespace Spirv;

std::map<uint32_t, uint32_t> FindConstantTables(const FSpirvModule& Module)
{
	std::map<uint32_t, uint32_t> Tables;
	std::set<uint32_t> Written; // piece by piece or with several values
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if ((Variable.Storage == StorageFunction || Variable.Storage == StoragePrivate) && Variable.Initializer)
		{
			Tables[Variable.Id] = Variable.Initializer;
		}
	}
	std::map<uint32_t, uint32_t> BaseOf; // access chain -> variable
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		for (const FSpirvInstruction& I : Block.Instructions)
		{
			if (I.Op == OpAccessChain || I.Op == OpInBoundsAccessChain)
			{
				BaseOf[I.Result] = I.Operands[0];
			}
			else if (I.Op == OpStore)
			{
				const FSpirvVariable* Whole = Module.FindVariable(I.Operands[0]);
				const bool bConstant = Whole && Module.FindConstant(I.Operands[1]);
				const auto [Known, bNew] =
					bConstant ? Tables.emplace(Whole->Id, I.Operands[1]) : std::pair(Tables.end(), false);
				if (!bConstant || Known->second != I.Operands[1])
				{
					Written.insert(Whole ? Whole->Id : BaseOf[I.Operands[0]]);
				}
			}
			else if (I.Op == OpExtInst && I.Operands[1] == ExtModf)
			{
				const uint32_t Pointer = I.Operands[3];
				Written.insert(Module.FindVariable(Pointer) ? Pointer : BaseOf[Pointer]);
			}
		}
	}
	for (const uint32_t Variable : Written)
	{
		Tables.erase(Variable);
	}
	std::erase_if(Tables,
		[&Module](const auto& Table)
		{
			const uint32_t Storage = Module.FindVariable(Table.first)->Storage;
			return Storage != StorageFunction && Storage != StoragePrivate;
		});
	return Tables;
}

} // namespace Drydock
