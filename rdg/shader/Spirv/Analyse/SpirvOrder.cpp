// Numbers the blocks of a structure as they stand in its text.
#include "SpirvOrder.h"

namespace Drydock
{

namespace
{

void Number(const FSpirvModule& Module, const FStructRegion& Region, FSpirvOrder& Order, uint32_t& Next)
{
	for (const FStructNode& Node : Region.Nodes)
	{
		if (Node.Kind == EStructNode::Block)
		{
			Order.Places.at(Module.BlockIndex.at(Node.Label)) = ++Next;
		}
		for (const FStructRegion& Inner : Node.Regions)
		{
			Number(Module, Inner, Order, Next);
		}
	}
}

} // namespace

FSpirvOrder FindOrder(const FSpirvModule& Module)
{
	FSpirvOrder Order;
	Order.Places.resize(Module.Blocks.size());
	Order.Loops.resize(Module.Blocks.size());
	std::vector<uint32_t> FirstBlocks;
	for (const FSpirvFunction& Function : Module.Functions)
	{
		if (Function.NumBlocks)
		{
			FirstBlocks.push_back(Function.FirstBlock);
		}
	}
	if (Module.Functions.empty())
	{
		FirstBlocks.push_back(0);
	}
	for (const uint32_t First : FirstBlocks)
	{
		const FSpirvStructure Structure = BuildSpirvStructure(Module, First);
		uint32_t Next = 0;
		Number(Module, Structure.Root, Order, Next);
		for (const auto& [Label, Headers] : Structure.Loops)
		{
			for (const uint32_t Header : Headers)
			{
				Order.Loops.at(Module.BlockIndex.at(Label)).push_back(Module.BlockIndex.at(Header));
			}
		}
	}
	return Order;
}

} // namespace Drydock
