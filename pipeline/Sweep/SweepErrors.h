// The numbers of the messages of `drydock sweep`. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum ESweepError
{
	ErrorSweepLarge = 1140,   // more tasks than 10,000, or more disk than is free, and no --yes
	ErrorSweepNoPlan = 1141,  // the folder has no plan, or one that is damaged
	ErrorSweepChanged = 1142, // something that a task depends on is different since the plan
	ErrorSweepCrash = 1143,   // the process that ran a task was ended
	ErrorSweepMissing = 1144, // results are missing, so there is nothing to reduce
	ErrorSweepEngine = 1145,  // what hands out the shards cannot be started, or failed
	WarnSweepAxis = 1146,     // an axis changes nothing, or something in the sweep leaves nothing out
};

} // namespace Drydock
